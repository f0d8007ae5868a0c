#include "app/commands/gear_study.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <limits>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// The table's columns are of bearings, so all but the speeds stay empty.
ResultRow row_of(const TableHead& head, const gearset::dynamics::SetModel& model, double input_speed) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  const auto put = [&](const char* name, double speed) {
    const auto found = std::find(head.names.begin(), head.names.end(), name);
    if (found != head.names.end())
      row.values[static_cast<std::size_t>(found - head.names.begin())] =
          in_table_unit(speed, 9.549296585513721);
  };
  put("input_speed_rpm", input_speed);
  put("carrier_speed_rpm", model.operation.speeds.carrier);
  return row;
}

std::string file_of(const ManifestHeader& header, const study::GearRunResult& result) {
  PointContent content = gear_run_content(result);
  content.attributes = {{"Conventions", "CF-1.10"},
                        {"title", header.case_name + ", vibration of the gear set"},
                        {"source", "Orbearing " + header.program_version},
                        {"case", header.case_name},
                        {"case_hash", header.case_hash},
                        {"program_version", header.program_version},
                        {"instruction_set", header.instruction_set},
                        {"fidelity", header.fidelity},
                        {"status", result.message.empty() ? "ok" : result.message}};
  return netcdf_bytes(content);
}

void present(const ResolvedCase& resolved, const study::GearRunResult& result, const Options& options) {
  std::vector<std::string> warnings = gear_dynamics_warnings(resolved);
  const std::vector<std::string> unused = require_used(resolved, use::gears);
  warnings.insert(warnings.end(), unused.begin(), unused.end());
  if (!result.steady) warnings.push_back(result.message);
  if (options.json) {
    nlohmann::ordered_json object{{"case", resolved.text("name")}};
    object.update(gear_run_json(result));
    object["assumptions"] = assumptions_json(resolved);
    object["warnings"] = warnings;
    object["versions"] = versions_json();
    fmt::print("{}\n", object.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", gear_run_text(result));
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
  }
}

}  // namespace

bool runs_gears_alone(const ResolvedCase& resolved) {
  return resolved.model() == planetary_drivetrain && !resolved.shape().several && !resolved.shape().bearing;
}

int run_gear_case(const ResolvedCase& resolved, const Options& options) {
  require_used(resolved, use::gears);
  const gearset::dynamics::SetModel model = moving_gears_of(resolved);
  if (!resolved.shape().teeth)
    throw BadInput(resolved.file() +
                   ": gearset.teeth: missing; required: teeth, which give loads and mesh frequency; "
                   "orbearing modes shows the natural frequencies of a set without");
  const ManifestHeader header = manifest_header(resolved, "gears");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  const study::GearRunResult result = study::run_gears(model, gear_run_options(resolved));
  if (!result.completed) throw ComputationFailed(resolved.text("name") + ": " + result.message);
  if (!folder.finished().contains(0))
    folder.keep(
        {{0, file_of(header, result), row_of(folder.head(), model, resolved.quantity("input.speed"))}});
  present(resolved, result, options);
  return 0;
}

}  // namespace orbearing::app
