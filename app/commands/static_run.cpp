#include "app/commands/static_run.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/static_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// The columns of a sweep that a bearing under a static load can fill.
ResultRow row_of(const TableHead& head, const StaticStudy& study) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  const auto put = [&](const char* name, double value) {
    const auto found = std::find(head.names.begin(), head.names.end(), name);
    if (found != head.names.end() && std::isfinite(value))
      row.values[static_cast<std::size_t>(found - head.names.begin())] = in_table_unit(value, 1.0);
  };
  const double rms = std::sqrt(study.contact_load.square().mean());
  put("inner_load_max_N", study.contact_load.maxCoeff());
  const Eigen::ArrayXd& outer = study.outer_load.size() > 0 ? study.outer_load : study.contact_load;
  put("outer_load_max_N", outer.maxCoeff());
  put("inner_load_rms_N", rms);
  put("outer_load_rms_N", std::sqrt(outer.square().mean()));
  put("inner_life_Mrev", 1e-6 * study.reference_life.inner);
  put("outer_life_Mrev", 1e-6 * study.reference_life.outer);
  return row;
}

std::string file_of(const ManifestHeader& header, const StaticStudy& study) {
  PointContent content = static_content(study);
  content.attributes = {{"Conventions", "CF-1.10"},
                        {"title", header.case_name + ", bearing under a static load"},
                        {"source", "Orbearing " + header.program_version},
                        {"case", header.case_name},
                        {"case_hash", header.case_hash},
                        {"program_version", header.program_version},
                        {"instruction_set", header.instruction_set},
                        {"fidelity", header.fidelity},
                        {"status", "ok"}};
  return netcdf_bytes(content);
}

void present(const ResolvedCase& resolved, const StaticStudy& study, const Options& options) {
  if (options.json) {
    nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", study.model}};
    object.update(static_json(study));
    object["assumptions"] = assumptions_json(resolved);
    object["warnings"] = study.warnings;
    object["versions"] = versions_json();
    fmt::print("{}\n", object.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", static_text(study));
    for (const std::string& warning : study.warnings) fmt::print("warning: {}\n", warning);
  }
}

}  // namespace

int run_static_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static")
    throw BadInput("--fidelity: found " + options.fidelity +
                   "; required: quasi-static for a single bearing under a static load");
  const std::vector<std::string> unused = require_used(resolved, use::static_load);
  const ManifestHeader header = manifest_header(resolved, "static");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  StaticStudy study = static_study(resolved);
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  if (!folder.finished().contains(0))
    folder.keep({{0, file_of(header, study), row_of(folder.head(), study)}});
  present(resolved, study, options);
  return 0;
}

}  // namespace orbearing::app
