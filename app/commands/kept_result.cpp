#include "app/commands/kept_result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/plausibility.hpp"
#include "app/study/sensitivity.hpp"
#include "app/study/sweep_study.hpp"
#include "orbearing/files.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

struct Shown {
  nlohmann::ordered_json json;  // of the analysis itself
  std::string text;
};

// Adds warnings of rare and impossible values among the results, speeds and loads.
Shown shown_of(const ResolvedCase& resolved, AnalysisResult& result) {
  Shown shown{json_of(result.record), result.heading + text_of(result.record)};
  std::vector<Observation> observed = observations(resolved);
  for (Observation& one : observations(shown.json)) observed.push_back(std::move(one));
  const Judgement judgement = judge(observed);
  result.warnings = joined(result.warnings, judgement.warnings);
  if (judgement.status == "ok") return shown;
  if (result.status == "ok") result.status = judgement.status;
  shown.json["status"] = judgement.status;
  shown.text = judgement.status + "\n\n" + shown.text;
  return shown;
}

// Case, model, what was found, then assumptions, warnings, versions and units.
nlohmann::ordered_json whole_json(const ResolvedCase& resolved, const AnalysisResult& result,
                                  const std::vector<AssumedEffect>& effects,
                                  const nlohmann::ordered_json& found) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", resolved.choice("model")}};
  object.update(found);
  object["assumptions"] = assumptions_json(resolved, effects);
  object["warnings"] = result.warnings;
  object["versions"] = versions_json();
  object["units"].update(units_of(result.record));  // stiffness has such an object of its own
  return object;
}

// Effects of assumptions: for a bearing under a static load, not for its other analyses.
std::vector<AssumedEffect> effects_of(const ResolvedCase& resolved, const ResultNames& names) {
  return names.name == std::string_view("static") ? assumed_effects(resolved) : std::vector<AssumedEffect>{};
}

/// Returns their check sums by name.
std::map<std::string, std::string> write_files(const std::filesystem::path& folder, const ResultNames& names,
                                               const AnalysisResult& result,
                                               const nlohmann::ordered_json& object) {
  std::vector<std::pair<std::string, std::string>> named = result.files;
  if (names.json_file != nullptr) named.emplace_back(names.json_file, object.dump(2) + "\n");
  for (const described::Entry& entry : result.record.entries())
    if (!entry.file.empty()) named.emplace_back(entry.file, csv_of(entry));
  std::vector<FileContent> files;
  for (const auto& [name, content] : named) files.push_back({folder / name, content});
  write_aside_and_rename(files);
  std::map<std::string, std::string> sums;
  for (const FileContent& file : files) sums[file.file.filename().string()] = checksum(file.content);
  return sums;
}

// "load_max_N" of "inner" may be the column inner_load_max_N.
void add_numbers(const std::string& prefix, const nlohmann::ordered_json& object,
                 std::vector<std::pair<std::string, double>>& numbers) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_number()) numbers.emplace_back(prefix + name, value.get<double>());
    if (value.is_object()) add_numbers(prefix + name + "_", value, numbers);
  }
}

}  // namespace

int compute_and_keep(const ResolvedCase& resolved, const ResultPlace& place, const Printing& print,
                     const ResultNames& names, const std::function<AnalysisResult()>& compute) {
  const ManifestHeader header = manifest_header(resolved, names.name);
  ResultFolder folder =
      open_results(place.folder, header, write_resolved(resolved), place.resume, print.quiet);
  AnalysisResult result = compute();
  const Shown shown = shown_of(resolved, result);
  const std::vector<AssumedEffect> effects = effects_of(resolved, names);
  const nlohmann::ordered_json object = whole_json(resolved, result, effects, shown.json);
  if (print.to.record) print.to.record(result.record);
  if (!folder.finished().contains(0)) {
    std::map<std::string, std::string> others;
    if (!folder.path().empty()) others = write_files(folder.path(), names, result, object);
    if (result.row.empty()) add_numbers("", shown.json, result.row);
    folder.keep({{0, result_file(header, names.title, result.record, result.status),
                  row_of_numbers(result.row, header), std::move(others)}});
  }
  present_result(object, shown.text + assumed_effects_text(resolved, effects), print);
  return result.failed ? 1 : 0;
}

void present_result(const nlohmann::ordered_json& object, const std::string& text, const Printing& print) {
  if (print.json) {
    print_object(object, print);
  } else if (!print.quiet) {
    // Before a text that may be longer than a screen: results are read with them.
    for (const nlohmann::ordered_json& warning : object.at("warnings"))
      fmt::print("warning: {}\n", printable(warning.get<std::string>()));
    fmt::print("{}{}", object.at("warnings").empty() ? "" : "\n", text);
  }
}

std::string result_file(const ManifestHeader& header, const char* what, const Record& record,
                        const std::string& status) {
  PointContent content = content_of(record);
  std::vector<std::pair<std::string, std::string>> attributes = result_attributes(header, what, status);
  for (auto& own : content.attributes)
    if (std::ranges::none_of(attributes, [&](const auto& one) { return one.first == own.first; }))
      attributes.push_back(std::move(own));
  content.attributes = std::move(attributes);
  return netcdf_bytes(content);
}

void present_record(const ResolvedCase& resolved, const Record& record,
                    const std::vector<std::string>& warnings, const Printing& print,
                    const std::string& more) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}};
  object.update(json_of(record));
  object["warnings"] = warnings;
  object["units"] = units_of(record);
  if (print.to.record) print.to.record(record);
  present_result(object, text_of(record) + more, print);
}

int run_analysis(const ResolvedCase& resolved, const ResultPlace& place, const Printing& print,
                 const Analysis& analysis) {
  const std::vector<std::string> unused = require_used(resolved, analysis.used);
  return compute_and_keep(resolved, place, print, analysis.names, [&] {
    AnalysisOptions options{.files = !place.folder.empty()};
    std::optional<Progress> bar;
    if (analysis.doing != nullptr) {
      bar.emplace(std::size_t{0}, analysis.parts, !print.quiet, analysis.doing,
                  analysis.simulated != nullptr ? analysis.simulated(resolved) : 0.0);
      options.progress = [&](double share) {
        bar->show(static_cast<std::size_t>(share * static_cast<double>(analysis.parts)));
      };
    }
    AnalysisResult result = analysis.compute(resolved, options);
    result.warnings = joined(unused, result.warnings);
    return result;
  });
}

nlohmann::ordered_json printed_json(const ResolvedCase& resolved, const Analysis& analysis) {
  const std::vector<std::string> unused = require_used(resolved, analysis.used);
  AnalysisResult result = analysis.compute(resolved, {});
  result.warnings = joined(unused, result.warnings);
  const Shown shown = shown_of(resolved, result);
  return whole_json(resolved, result, effects_of(resolved, analysis.names), shown.json);
}

}  // namespace orbearing::app
