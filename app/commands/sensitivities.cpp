#include "app/commands/sensitivities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "app/case/spectrum_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/progress.hpp"
#include "app/study/derivatives.hpp"

namespace orbearing::app {

namespace {

// In the manifest: tables of different results or inputs do not continue in one folder.
std::string name_of_table(const ScalarResult& result, const SensitivitiesOptions& options) {
  if (result.is_at_rest() && options.result.empty() && options.by.empty()) return "sensitivities";
  return fmt::format("sensitivities of {}, {}, by {}", result.quantity, fidelity_or_default(options.fidelity),
                     options.by.empty() ? "all inputs" : fmt::format("{}", fmt::join(options.by, ", ")));
}

void require_inputs(const ResolvedCase& resolved, const ScalarResult& result,
                    const SensitivitiesOptions& options) {
  if (options.by.empty() && !result.is_at_rest())
    throw BadInput("--by: missing; required: inputs, each of which takes two runs in motion");
  for (const std::string& path : options.by)
    if (!resolved.has(path)) throw BadInput("--by: found " + path + "; required: an input of the case");
}

// Results of runs in motion that are done, one line of a file each, so that --resume continues behind them.
class KeptRuns {
 public:
  explicit KeptRuns(const std::filesystem::path& folder) {
    if (folder.empty()) return;
    file_ = AppendOnlyFile(folder / "runs.jsonl");
    const std::string text = file_->content();
    const std::size_t whole = text.rfind('\n') + 1;  // 0 where there is none
    file_->truncate(whole);
    std::istringstream lines(text.substr(0, whole));
    for (std::string line; std::getline(lines, line);) {
      const auto run = nlohmann::json::parse(line, nullptr, false);
      if (run.is_object()) results_[run.value("run", "")] = run.value("result", 0.0);
    }
  }

  double result(const std::string& name, const std::function<double()>& compute) {
    {
      const std::scoped_lock lock(writing_);
      if (const auto known = results_.find(name); known != results_.end()) return known->second;
    }
    const double result = compute();
    const std::scoped_lock lock(writing_);
    if (file_) file_->append(nlohmann::ordered_json{{"run", name}, {"result", result}}.dump() + "\n");
    return result;
  }

 private:
  std::optional<AppendOnlyFile> file_;
  std::map<std::string, double> results_;
  std::mutex writing_;
};

Derivatives derivatives_of(const ResolvedCase& resolved, const ScalarResult& result,
                           const ScalarResult::Value& here, const SensitivitiesOptions& options) {
  KeptRuns kept(result.is_at_rest() ? "" : options.output);
  std::optional<Progress> progress;
  return derivatives(
      resolved, result, here,
      {.paths = options.by,
       .jobs = options.jobs,
       .progress =
           [&](std::size_t done, std::size_t all) {
             if (!progress) progress.emplace(std::size_t{0}, all, !options.print.quiet, "runs: ");
             progress->show(done);
           },
       .remember = [&](const auto& name, const auto& compute) { return kept.result(name, compute); }});
}

}  // namespace

std::vector<std::string> problems(const SensitivitiesOptions& options) {
  return problems(ResultPlace{options.output, options.resume}, Printing{.json = true});
}

int execute(const SensitivitiesOptions& options) {
  const ResolvedCase resolved = point_of(options.stated);
  const ScalarResult result = scalar_result(resolved, options.fidelity, options.result);
  require_inputs(resolved, result, options);
  require_effect({resolved}, result.analysis, options.by);
  const std::vector<std::string> warnings =
      joined(require_used(resolved, result.analysis), spectrum_warnings(resolved, "sensitivities"));
  const ScalarResult::Value here = value_here(resolved, result);
  const std::string table = name_of_table(result, options);
  const ResultNames names{table.c_str(), "sensitivities of a result", "sensitivities.json"};
  const ResultPlace place{options.output, options.resume};
  return compute_and_keep(resolved, place, options.print, names, [&]() -> AnalysisResult {
    const Derivatives found = derivatives_of(resolved, result, here, options);
    AnalysisResult described{.record = record_of(found), .warnings = warnings};
    described.files = {{"sensitivities.csv", derivatives_csv(found)}};
    return described;
  });
}

}  // namespace orbearing::app
