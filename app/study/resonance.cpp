#include "app/study/resonance.hpp"

#include <algorithm>
#include <cmath>

#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"

namespace orbearing::app {

diagnosis::ModesAtSpeed modes_at_rpm(const ResolvedCase& resolved, double rpm) {
  const gearset::dynamics::SetModel model = gear_model_of(resolved.with({input_speed(rpm)}));
  return {rpm * kRadiansPerSecond, model.operation.mesh_frequency,
          diagnosis::named_frequencies(modes_at_speed(model), model.parameters.planets)};
}

bool has_resonances(const ResolvedCase& resolved) {
  const CaseShape& shape = resolved.shape();
  return resolved.model() == planetary_drivetrain && !shape.several && shape.teeth && shape.bearing &&
         resolved.flag("gearset.mesh_variation");
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

}  // namespace orbearing::app
