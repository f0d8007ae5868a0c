#include "app/commands/gear_study.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <limits>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

ResultRow row_of(const TableHead& head, const gearset::dynamics::SetModel& model, double input_speed) {
  constexpr double kRpm = 9.549296585513721;  // [rpm/(rad/s)]
  return lone_row(head, {{"input_speed_rpm", kRpm * input_speed},
                         {"carrier_speed_rpm", kRpm * model.operation.speeds.carrier}});
}

void present(const ResolvedCase& resolved, const study::GearRunResult& result, const Options& options) {
  std::vector<std::string> warnings = gear_dynamics_warnings(resolved);
  const std::vector<std::string> unused = require_used(resolved, use::gears);
  warnings.insert(warnings.end(), unused.begin(), unused.end());
  if (!result.steady) warnings.push_back(result.message);
  present_lone_result(lone_result_json(resolved, gear_run_json(result), warnings), gear_run_text(result), options);
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
        {{0,
          lone_result_file(header, "vibration of the gear set", gear_run_content(result),
                           result.message.empty() ? "ok" : result.message),
          row_of(folder.head(), model, resolved.quantity("input.speed"))}});
  present(resolved, result, options);
  return 0;
}

}  // namespace orbearing::app
