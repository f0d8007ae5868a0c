#include "app/commands/crown.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <mutex>

#include "app/case/resolved_writer.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

std::string netcdf_of(const ManifestHeader& header, const CrownStudy& study, const Record& record) {
  return result_file(header, "crowning of the planet bearing's rollers", record,
                     study.failed == 0 ? "ok" : "some points found no static equilibrium");
}

CrownStudy computed(const CrownRequest& request, const CrownOptions& options) {
  Progress progress(0, grid_size(request), !options.print.quiet);
  std::mutex one_at_a_time;
  return crown_study(request, options.jobs, [&](std::size_t done) {
    const std::scoped_lock lock(one_at_a_time);
    progress.show(done);
  });
}

nlohmann::ordered_json result_json(const ResolvedCase& resolved, const CrownChoices& choices,
                                   const std::vector<std::string>& noted, const CrownStudy& study,
                                   const Record& record) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"options", choices_json(choices)}};
  object.update(json_of(record));
  object["assumptions"] = assumptions_json(resolved);
  object["warnings"] = crown_warnings(resolved, choices, noted, study);
  object["versions"] = versions_json();
  object["units"] = units_of(record);
  return object;
}

}  // namespace

std::vector<std::string> problems(const CrownOptions& options) {
  return problems(ResultPlace{options.output, options.resume}, options.print);
}

int execute(const CrownOptions& options) {
  const ResolvedCase given = case_of(options.stated);
  const auto [resolved, noted] = crown_case(given, options.choices);
  const CrownRequest request = crown_request(resolved, options.choices);
  require_crown_uses(resolved, options.choices);
  const ManifestHeader header = manifest_header(resolved, choices_text(options.choices));
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.print.quiet);
  const fs::path file = fs::path(options.output) / crown_file_name;
  CrownResult result;
  if (folder.finished().contains(0) && fs::exists(file)) {
    result = read_crown(options.output);
  } else {
    CrownStudy study = computed(request, options);
    put_lives_in_run(given, options.choices.of_set, options.jobs, study);
    Record record;
    describe(record, study);
    if (options.print.to.record) options.print.to.record(record);
    result = {result_json(resolved, options.choices, noted, study, record),
              text_of(record) + text_in_run(study), study.failed};
    std::map<std::string, std::string> others;
    if (!options.output.empty()) {
      write_crown(options.output, result);
      others = checksums_of(options.output, {crown_file_name});
    }
    folder.keep({{0, netcdf_of(header, study, record), row_of_numbers({}, header), std::move(others)}});
  }
  present_result(result.object, result.text, options.print);
  if (result.failed == 0) return 0;
  print_failures(fmt::format("crown: {} points found no static equilibrium; their status gives the reason",
                             result.failed),
                 options.print);
  return 1;
}

}  // namespace orbearing::app
