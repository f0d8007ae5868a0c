#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <mutex>

#include "app/case/printable.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

std::string netcdf_of(const ManifestHeader& header, const CrownStudy& study, const Record& record) {
  PointContent content = content_of(record);
  const std::vector<std::pair<std::string, std::string>> common{
      {"Conventions", "CF-1.10"},
      {"title", header.case_name + ", crowning of the planet bearing's rollers"},
      {"source", "Orbearing " + header.program_version},
      {"case", header.case_name},
      {"case_hash", header.case_hash},
      {"program_version", header.program_version},
      {"instruction_set", header.instruction_set},
      {"options", header.fidelity},
      {"status", study.failed == 0 ? "ok" : "some points found no static equilibrium"}};
  content.attributes.insert(content.attributes.end(), common.begin(), common.end());
  return netcdf_bytes(content);
}

CrownStudy computed(const CrownRequest& request, const Options& options) {
  Progress progress(0, grid_size(request), !options.quiet);
  std::mutex one_at_a_time;
  return crown_study(request, options.jobs, [&](std::size_t done) {
    const std::scoped_lock lock(one_at_a_time);
    progress.show(done);
  });
}

// Of the swept values a spectrum takes the speeds.
std::vector<std::string> require_crown_uses(const ResolvedCase& resolved, const CrownOptions& options) {
  const bool spectrum = options.spectrum || !options.shares.empty();
  return require_used(resolved, use::crown, spectrum ? Axes::speed : Axes::none);
}

nlohmann::ordered_json result_json(const ResolvedCase& resolved, const CrownOptions& options,
                                   const std::vector<std::string>& noted, const CrownStudy& study,
                                   const Record& record) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"options", options_json(options)}};
  object.update(json_of(record));
  object["assumptions"] = assumptions_json(resolved);
  std::vector<std::string> warnings = noted;
  for (std::string& warning : gear_warnings(resolved)) warnings.push_back(std::move(warning));
  for (std::string& warning : slope_warnings(resolved)) warnings.push_back(std::move(warning));
  for (std::string& warning : overturning_warnings(resolved.without_sweep()))
    warnings.push_back(std::move(warning));
  for (std::string& warning : clearance_warnings(resolved)) warnings.push_back(std::move(warning));
  const std::vector<std::string> unused = require_crown_uses(resolved, options);
  warnings.insert(warnings.end(), unused.begin(), unused.end());
  warnings.insert(warnings.end(), study.warnings.begin(), study.warnings.end());
  object["warnings"] = warnings;
  object["versions"] = versions_json();
  object["units"] = units_of(record);
  return object;
}

// Columns of a sweep have no place for a study: the row says only that it was done.
ResultRow done_row(const TableHead& head) {
  return {std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
}

}  // namespace

int crown_command(const Options& options) {
  require_output(options);
  const auto [resolved, noted] = crown_case(case_of(options), options.crown);
  const CrownRequest request = crown_request(resolved, options.crown);
  require_crown_uses(resolved, options.crown);
  const ManifestHeader header = manifest_header(resolved, options_text(options.crown));
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  const fs::path file = fs::path(options.output) / crown_file_name;
  CrownResult result;
  if (folder.finished().contains(0) && fs::exists(file)) {
    result = read_crown(options.output);
  } else {
    const CrownStudy study = computed(request, options);
    Record record;
    describe(record, study);
    if (options.take_record) options.take_record(record);
    result = {result_json(resolved, options.crown, noted, study, record), text_of(record), study.failed};
    std::map<std::string, std::string> others;
    if (!options.output.empty()) {
      write_crown(options.output, result);
      others = checksums_of(options.output, {crown_file_name});
    }
    folder.keep({{0, netcdf_of(header, study, record), done_row(folder.head()), std::move(others)}});
  }
  if (options.json)
    print_object(result.object, options);
  else if (!options.quiet)
    fmt::print("{}", result.text);
  for (const auto& warning : result.object["warnings"])
    if (!options.json && !options.quiet) fmt::print("warning: {}\n", printable(warning.get<std::string>()));
  if (result.failed == 0) return 0;
  print_failures(fmt::format("crown: {} points found no static equilibrium; their status gives the reason",
                             result.failed),
                 options);
  return 1;
}

}  // namespace orbearing::app
