#include "app/commands/lone_result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/case/printable.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/checksum.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/point_file.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/plausibility.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// Case, model, what was found, then assumptions, warnings and versions.
nlohmann::ordered_json whole_json(const ResolvedCase& resolved, const LoneResult& result) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", resolved.choice("model")}};
  object.update(result.json);
  object["assumptions"] = assumptions_json(resolved);
  object["warnings"] = result.warnings;
  object["versions"] = versions_json();
  if (!result.units.is_null())
    object["units"].update(result.units);  // stiffness has such an object of its own
  return object;
}

// Rare and impossible values in what was found, and in what speeds and loads say themselves.
void judge_plausibility(const ResolvedCase& resolved, LoneResult& result) {
  std::vector<Observation> observed = observations(resolved);
  for (Observation& one : observations(result.json)) observed.push_back(std::move(one));
  const Judgement judgement = judge(observed);
  result.warnings = joined(result.warnings, judgement.warnings);
  if (judgement.status == "ok") return;
  if (result.status == "ok") result.status = judgement.status;
  result.json["status"] = judgement.status;
  result.text = judgement.status + "\n\n" + result.text;
}

/// Returns their check sums by name.
std::map<std::string, std::string> write_files(const std::filesystem::path& folder,
                                               const LoneAnalysis& analysis, const LoneResult& result,
                                               const nlohmann::ordered_json& object) {
  std::vector<FileContent> files;
  const std::string printed = object.dump(2) + "\n";
  if (analysis.json_file != nullptr) files.push_back({folder / analysis.json_file, printed});
  for (const auto& [name, content] : result.files) files.push_back({folder / name, content});
  write_aside_and_rename(files);
  std::map<std::string, std::string> sums;
  for (const FileContent& file : files) sums[file.file.filename().string()] = checksum(file.content);
  return sums;
}

// "load_max_N" of "inner" may be the column inner_load_max_N.
void add_to_row(const std::string& prefix, const nlohmann::ordered_json& object,
                std::vector<std::pair<std::string, double>>& row) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_number()) row.emplace_back(prefix + name, value.get<double>());
    if (value.is_object()) add_to_row(prefix + name + "_", value, row);
  }
}

}  // namespace

LoneResult recorded_result(const Record& record, std::vector<std::string> warnings) {
  LoneResult result{.json = json_of(record),
                    .text = text_of(record),
                    .content = content_of(record),
                    .warnings = std::move(warnings),
                    .units = units_of(record)};
  add_to_row("", result.json, result.row);
  for (const described::Entry& entry : record.entries())
    if (!entry.file.empty()) result.files.emplace_back(entry.file, csv_of(entry));
  return result;
}

int run_alone(const ResolvedCase& resolved, const Options& options, const LoneAnalysis& analysis,
              const std::function<LoneResult()>& compute) {
  const ManifestHeader header = manifest_header(resolved, analysis.fidelity);
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  LoneResult result = compute();
  judge_plausibility(resolved, result);
  const nlohmann::ordered_json object = whole_json(resolved, result);
  if (!folder.finished().contains(0)) {
    std::map<std::string, std::string> others;
    if (!folder.path().empty()) others = write_files(folder.path(), analysis, result, object);
    folder.keep({{0, lone_result_file(header, analysis.title, result.content, result.status),
                  lone_row(folder.head(), result.row), std::move(others)}});
  }
  present_lone_result(object, result.text, options);
  return result.failed ? 1 : 0;
}

std::string lone_result_file(const ManifestHeader& header, const char* what, PointContent content,
                             const std::string& status) {
  std::vector<std::pair<std::string, std::string>> attributes = result_attributes(header, what, status);
  for (auto& own : content.attributes)
    if (std::ranges::none_of(attributes, [&](const auto& one) { return one.first == own.first; }))
      attributes.push_back(std::move(own));
  content.attributes = std::move(attributes);
  return netcdf_bytes(content);
}

void present_lone_result(const nlohmann::ordered_json& object, const std::string& text,
                         const Options& options) {
  if (options.json) {
    print_object(object, options);
  } else if (!options.quiet) {
    fmt::print("{}", text);
    for (const nlohmann::ordered_json& warning : object.at("warnings"))
      fmt::print("warning: {}\n", printable(warning.get<std::string>()));
  }
}

void present_record(const ResolvedCase& resolved, const Record& record,
                    const std::vector<std::string>& warnings, const Options& options,
                    const std::string& more) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}};
  object.update(json_of(record));
  object["warnings"] = warnings;
  object["units"] = units_of(record);
  present_lone_result(object, text_of(record) + more, options);
}

ResultRow lone_row(const TableHead& head, const std::vector<std::pair<std::string, double>>& values) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  for (const auto& [name, value] : values) {
    const auto found = std::find(head.names.begin(), head.names.end(), name);
    if (found != head.names.end() && std::isfinite(value))
      row.values[static_cast<std::size_t>(found - head.names.begin())] = in_table_unit(value, 1.0);
  }
  return row;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace orbearing::app
