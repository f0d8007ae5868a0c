#include "app/commands/static_run.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/ball_study.hpp"
#include "app/study/static_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// The columns of a sweep that a single bearing can fill.
ResultRow filled(const TableHead& head, const std::vector<std::pair<const char*, double>>& values) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  for (const auto& [name, value] : values) {
    const auto found = std::find(head.names.begin(), head.names.end(), name);
    if (found != head.names.end() && std::isfinite(value))
      row.values[static_cast<std::size_t>(found - head.names.begin())] = in_table_unit(value, 1.0);
  }
  return row;
}

ResultRow row_of(const TableHead& head, const StaticStudy& study) {
  const Eigen::ArrayXd& inner = study.contact_load;
  const Eigen::ArrayXd& outer = study.outer_load.size() > 0 ? study.outer_load : study.contact_load;
  return filled(head, {{"inner_load_max_N", inner.maxCoeff()},
                       {"outer_load_max_N", outer.maxCoeff()},
                       {"inner_load_rms_N", std::sqrt(inner.square().mean())},
                       {"outer_load_rms_N", std::sqrt(outer.square().mean())},
                       {"inner_life_Mrev", 1e-6 * study.reference_life.inner},
                       {"outer_life_Mrev", 1e-6 * study.reference_life.outer}});
}

ResultRow row_of(const TableHead& head, const BallStudy& study) {
  const system::BallMeans& m = study.run.means;
  return filled(head, {{"inner_load_max_N", m.inner_load_max},
                       {"outer_load_max_N", m.outer_load_max},
                       {"inner_load_rms_N", m.inner_load_rms},
                       {"outer_load_rms_N", m.outer_load_rms},
                       {"inner_life_Mrev", 1e-6 * m.life.inner},
                       {"outer_life_Mrev", 1e-6 * m.life.outer},
                       {"life_h", study.life_hours},
                       {"cage_slip", m.cage_slip},
                       {"film_inner_um", 1e6 * m.inner_film},
                       {"film_outer_um", 1e6 * m.outer_film}});
}

std::string file_of(const ManifestHeader& header, const char* what, PointContent content) {
  content.attributes = {{"Conventions", "CF-1.10"},
                        {"title", header.case_name + ", " + what},
                        {"source", "Orbearing " + header.program_version},
                        {"case", header.case_name},
                        {"case_hash", header.case_hash},
                        {"program_version", header.program_version},
                        {"instruction_set", header.instruction_set},
                        {"fidelity", header.fidelity},
                        {"status", "ok"}};
  return netcdf_bytes(content);
}

nlohmann::ordered_json result_of_one(const ResolvedCase& resolved, const nlohmann::ordered_json& results,
                                     const std::vector<std::string>& warnings) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", resolved.choice("model")}};
  object.update(results);
  object["assumptions"] = assumptions_json(resolved);
  object["warnings"] = warnings;
  object["versions"] = versions_json();
  return object;
}

void present(const nlohmann::ordered_json& object, const std::string& text, const Options& options) {
  if (options.json) {
    fmt::print("{}\n", object.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", text);
    for (const nlohmann::ordered_json& warning : object.at("warnings"))
      fmt::print("warning: {}\n", warning.get<std::string>());
  }
}

}  // namespace

int run_ball_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static" && options.fidelity != "dynamic")
    throw BadInput("--fidelity: found " + options.fidelity + "; required: dynamic for a ball bearing in time");
  const std::vector<std::string> unused = require_used(resolved, use::ball_run);
  const ManifestHeader header = manifest_header(resolved, "dynamic");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  BallStudy study = [&] {
    constexpr std::size_t parts = 1000;
    Progress progress(0, parts, !options.quiet, "time, in thousandths: ");
    return ball_study(resolved, [&](double share) { progress.show(static_cast<std::size_t>(share * parts)); });
  }();
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  const nlohmann::ordered_json object = result_of_one(resolved, ball_json(study), study.warnings);
  if (!folder.finished().contains(0)) {
    if (!folder.path().empty())
      write_aside_and_rename(folder.path() / ball_file_name, object.dump(2) + "\n");
    folder.keep({{0, file_of(header, "ball bearing in time", ball_content(study)), row_of(folder.head(), study)}});
  }
  present(object, ball_text(study), options);
  return 0;
}

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
    folder.keep({{0, file_of(header, "bearing under a static load", static_content(study)), row_of(folder.head(), study)}});
  present(result_of_one(resolved, static_json(study), study.warnings), static_text(study), options);
  return 0;
}

}  // namespace orbearing::app
