#include "app/commands/duplex_run.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <limits>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/duplex_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

constexpr const char* kDuplexFile = "duplex.json";

// The table's columns are of lives: all but the largest load stay empty.
ResultRow pair_row(const TableHead& head, const DuplexStudy& study) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  for (std::size_t i = 0; i < head.names.size(); ++i)
    if (head.names[i] == "inner_load_max_N" || head.names[i] == "outer_load_max_N")
      row.values[i] = in_table_unit(study.point.state.contact_load.maxCoeff(), 1.0);
  return row;
}

std::string pair_file(const ManifestHeader& header, const DuplexStudy& study) {
  PointContent content = duplex_content(study);
  content.attributes = {{"Conventions", "CF-1.10"},
                        {"title", header.case_name + ", shaft on a duplex pair"},
                        {"source", "Orbearing " + header.program_version},
                        {"case", header.case_name},
                        {"case_hash", header.case_hash},
                        {"program_version", header.program_version},
                        {"instruction_set", header.instruction_set},
                        {"fidelity", header.fidelity},
                        {"status", "ok"}};
  return netcdf_bytes(content);
}

void keep_pair(const ManifestHeader& header, const std::string& object, const DuplexStudy& study,
               ResultFolder& folder) {
  if (folder.finished().contains(0)) return;
  if (!folder.path().empty()) {
    const std::string csv = predictions_csv(study);
    write_aside_and_rename({{folder.path() / kDuplexFile, object}, {folder.path() / "predictions.csv", csv}});
  }
  folder.keep({{0, pair_file(header, study), pair_row(folder.head(), study)}});
}

void present_pair(const nlohmann::ordered_json& object, const std::string& text,
                  const std::vector<std::string>& warnings, const Options& options) {
  if (options.json) {
    fmt::print("{}\n", object.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", text);
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
  }
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

int duplex_modes(const ResolvedCase& resolved, const Options& options) {
  if (options.speed)
    throw BadInput("--speed: found " + *options.speed +
                   "; required: none for the model duplex-pair, whose shaft "
                   "stands");
  const std::vector<std::string> unused = require_used(resolved, use::duplex_modes);
  const PairPoint point = pair_point(resolved);
  const std::vector<std::string> warnings = joined(unused, point.warnings);
  nlohmann::ordered_json object{{"case", resolved.text("name")}};
  object.update(pair_modes_json(point));
  object["warnings"] = warnings;
  present_pair(object, pair_modes_text(point), warnings, options);
  return 0;
}

int run_duplex_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static")
    throw BadInput("--fidelity: found " + options.fidelity +
                   "; required: none for the model duplex-pair, whose shaft stands");
  const std::vector<std::string> unused = require_used(resolved, use::duplex_run);
  const ManifestHeader header = manifest_header(resolved, "duplex");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  const DuplexStudy study = duplex_study(resolved);
  const std::vector<std::string> warnings = joined(unused, study.warnings);
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", resolved.choice("model")}};
  object.update(duplex_json(study));
  object["assumptions"] = assumptions_json(resolved);
  object["warnings"] = warnings;
  object["versions"] = versions_json();
  keep_pair(header, object.dump(2) + "\n", study, folder);
  present_pair(object, duplex_text(study), warnings, options);
  return 0;
}

}  // namespace orbearing::app
