#include "app/commands/modes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machines.hpp"
#include "app/case/mistake.hpp"
#include "app/case/units.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/case/use_conditions.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/plain_commands.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/gear_case.hpp"

namespace orbearing::app {

namespace {

// [rad/s]  0 where none is stated.
double speed_option(const std::string& text) {
  if (text.empty()) return 0.0;
  const Reading<double> speed = read_quantity(text, dimension::angular_speed);
  if (speed.value && *speed.value >= 0.0) return *speed.value;
  throw BadInput("--speed: found '" + text + "'" + (speed.value ? "" : ": " + speed.fault) +
                 "; required: an angular speed like '6000 rpm', not negative");
}

// The case with the speed of that option instead of the one at `path`.
ResolvedCase with_speed(const ResolvedCase& resolved, const std::string& path, const std::string& speed) {
  speed_option(speed);
  return named_by_option({{"--set: " + path + ": ", "--speed: "}},
                         [&] { return resolved.with(path, speed); });
}

// The stationary set, or the set rotating at a speed of its driven member (of its carrier where it has no
// teeth).
gearset::dynamics::SetModel model_at(const ResolvedCase& resolved, const std::string& stated) {
  const double speed = speed_option(stated);
  if (speed == 0.0 || resolved.model() != planetary_drivetrain || !resolved.shape().teeth)
    return gear_model_of(resolved, speed);
  return gear_model_of(with_speed(resolved, keys().speed, stated));
}

// Natural frequencies of stationary gears without a bearing depend on neither power nor speed, which a case
// may then leave out: any values replace them.
ResolvedCase point_for_modes(const StatedCase& stated, bool turns) try {
  return point_of(stated);
} catch (const BadInput& error) {
  const auto is_of_the_drive = [](const std::string& message) {
    return message.find(": input.power: missing") != std::string::npos ||
           message.find(": input.speed: missing") != std::string::npos ||
           message.find(": input.member: missing") != std::string::npos;
  };
  if (stated.given || turns || !std::ranges::all_of(error.messages, is_of_the_drive)) throw;
  StatedCase driven = stated;
  for (const auto& [path, value] :
       {std::pair(keys().power, "1 kW"), {keys().speed, "1000 rpm"}, {keys().driven_member, "sun"}})
    if (std::ranges::any_of(error.messages,
                            [missing = std::string(": ") + path + ": missing"](const std::string& message) {
                              return message.find(missing) != std::string::npos;
                            }))
      driven.settings.push_back(std::string(path) + "=" + value);
  const ResolvedCase resolved = point_of(driven);
  if (resolved.shape().bearing) throw;
  return resolved;
}

}  // namespace

int execute(const ModesOptions& options) {
  const bool turns = !options.speed.empty();
  const ResolvedCase resolved = point_for_modes(options.stated, turns);
  if (machine_analysis(resolved.model(), ModesOptions::command) != nullptr) {
    const ResolvedCase at = turns ? with_speed(resolved, keys().shaft_speed, options.speed) : resolved;
    return present_plain(at, result_of_machine(at, ModesOptions::command), options.print);
  }
  const double speed = speed_option(options.speed);
  if (resolved.model() == planetary_drivetrain && stated_drivetrain(resolved).has_pairs())
    require_used(resolved, AnalysisId::modes);  // refuses before it computes
  const gearset::dynamics::SetModel model = model_at(resolved, options.speed);
  std::vector<std::string> warnings =
      joined(gear_dynamics_warnings(resolved),
             require_used(resolved, speed > 0.0 ? AnalysisId::modes_at_speed : AnalysisId::modes));
  if (speed > 0.0 && resolved.has(keys().speed) && resolved.location(keys().speed).option)
    warnings.push_back(fmt::format("{}: {} has no effect with --speed, which replaces it", keys().speed,
                                   resolved.given(keys().speed)));
  Record record;
  describe(record, mode_study(model, speed > 0.0));
  if (speed == 0.0 && carrier_is_body(resolved, ""))
    record.child("in_three_dimensions", "with the carrier's bearings, axial motion and tilts", resolved,
                 describe_spatial_modes);
  if (speed > 0.0) record.child("campbell", "frequencies over speed", campbell(model, speed)).detail = true;
  present_record(resolved, record, warnings, options.print);
  return 0;
}

}  // namespace orbearing::app
