#include "app/study/resonance_lines.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/case/bearing_type.hpp"
#include "app/case/set_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"

namespace orbearing::app {

diagnosis::ModesAtSpeed modes_at_rpm(const ResolvedCase& resolved, double rpm) {
  const gearset::dynamics::SetModel model = gear_model_of(resolved.with({input_speed(rpm)}));
  return {rpm * kRadiansPerSecond, model.operation.mesh_frequency,
          diagnosis::named_frequencies(modes_at_speed(model), model.parameters.planets)};
}

std::vector<Resonance> resonances(const ResolvedCase& resolved, double lowest_rpm, double highest_rpm) {
  const gearset::PlanetarySet set = drivetrain_of(resolved).set;
  const auto modes_at = [&](double speed) { return modes_at_rpm(resolved, speed * kRpm); };
  std::vector<Resonance> list;
  for (const diagnosis::Meeting& meeting :
       diagnosis::resonances(lowest_rpm * kRadiansPerSecond, highest_rpm * kRadiansPerSecond, set, modes_at))
    list.push_back({.kind = kind_name(meeting.mode.kind),
                    .mode = meeting.mode.name,
                    .frequency = meeting.mode.frequency,
                    .harmonic = meeting.order,
                    .speed = meeting.speed});
  return list;
}

std::optional<Resonance> nearest(const std::vector<Resonance>& resonances, double speed) {
  const auto found = std::min_element(resonances.begin(), resonances.end(),
                                      [&](const Resonance& one, const Resonance& other) {
                                        return std::abs(one.speed - speed) < std::abs(other.speed - speed);
                                      });
  if (found == resonances.end() || !diagnosis::is_near(found->speed, speed)) return std::nullopt;
  return *found;
}

namespace {

std::vector<Setting> other_settings(std::vector<Setting> settings) {
  std::erase_if(settings, [](const Setting& setting) { return setting.path == kSpeedPath; });
  return settings;
}

// Whether resonances of its gears affect the motion of a case's bearings: one set with bearings, whose meshes
// vary. Several sets have no gear dynamics yet.
bool has_resonances(const ResolvedCase& resolved) {
  const CaseShape& shape = resolved.shape();
  return resolved.model() == planetary_drivetrain && !shape.several && shape.teeth && shape.bearing &&
         has_cylindrical_rollers(resolved) && !has_planet_pairs(resolved) &&
         resolved.flag("gearset.mesh_variation");
}

}  // namespace

std::vector<double> speeds_rpm(const ResolvedCase& resolved) {
  std::vector<double> speeds;
  for (const double speed : swept_speeds(resolved)) speeds.push_back(speed_in_rpm(speed));
  return speeds;
}

LinesOfResonances::LinesOfResonances(const ResolvedCase& resolved) : resolved_(resolved.without_sweep()) {
  const std::vector<double> speeds = speeds_rpm(resolved);
  const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
  lowest_ = *low;
  highest_ = *high;
}

const std::vector<Resonance>& LinesOfResonances::of(const std::vector<Setting>& settings) {
  const std::vector<Setting> line = other_settings(settings);
  const auto [position, is_new] = lines_.try_emplace(line);
  if (is_new) position->second = computed(line);
  return position->second;
}

// A line on which the gears cannot be computed has points that say why.
std::vector<Resonance> LinesOfResonances::computed(const std::vector<Setting>& line) const try {
  return resonances(line.empty() ? resolved_ : resolved_.with(line), lowest_, highest_);
} catch (const std::exception&) {
  return {};
}

void name_resonances(const ResolvedCase& resolved, SweepRequest& request) {
  if (!in_time(fidelity_of(request.header.fidelity)) || !has_resonances(resolved)) return;
  request.header.resonances = true;
  request.resonance_of = [lines = std::make_shared<LinesOfResonances>(resolved)](const SweepPoint& point) {
    return nearest(lines->of(point.settings), point.input_speed);
  };
}

}  // namespace orbearing::app
