#include "app/study/resonance_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "app/case/use_conditions.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"

namespace orbearing::app {

diagnosis::ModesAtSpeed modes_at_rpm(const ResolvedCase& resolved, double rpm) {
  return diagnosis::named_modes_at(rpm * kRadiansPerSecond, gear_model_of(resolved.with({input_speed(rpm)})));
}

std::vector<Resonance> resonances(const ResolvedCase& resolved, double lowest_rpm, double highest_rpm) {
  const gearset::PlanetarySet set = drivetrain_of(resolved).set;
  const auto modes_at = [&](double speed) { return modes_at_rpm(resolved, speed * kRpm); };
  std::vector<Resonance> list;
  for (const diagnosis::Meeting& meeting :
       diagnosis::resonances(lowest_rpm * kRadiansPerSecond, highest_rpm * kRadiansPerSecond, set, modes_at))
    list.push_back({.kind = analysis::kind_name(meeting.mode.kind),
                    .mode = meeting.mode.name,
                    .frequency = meeting.mode.frequency,
                    .harmonic = meeting.order,
                    .speed = meeting.speed,
                    .change = meeting.change});
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

std::vector<double> speeds_rpm(const ResolvedCase& resolved) {
  std::vector<double> speeds;
  for (const double speed : swept_speeds(resolved)) speeds.push_back(speed_in_rpm(speed));
  return speeds;
}

ResonancesOfLine resonances_by_line(const ResolvedCase& resolved) {
  const auto ends = std::ranges::minmax(speeds_rpm(resolved));
  const auto lines = std::make_shared<std::map<std::vector<Setting>, std::vector<Resonance>>>();
  return [ in = resolved.without_sweep(), ends, lines ](std::vector<Setting> line) -> const auto& {
    std::erase_if(line, [](const Setting& setting) { return setting.path == keys().speed; });
    const auto [position, is_new] = lines->try_emplace(line);
    if (is_new) try {
        position->second = resonances(line.empty() ? in : in.with(line), ends.min, ends.max);
      } catch (
          const std::exception&) {  // a line on which the gears cannot be computed has points with the reason
      }
    return position->second;
  };
}

void name_resonances(const ResolvedCase& resolved, SweepRequest& request) {
  if (!in_time(fidelity_of(request.header.fidelity)) || !resonances_are_named(resolved, "")) return;
  request.header.resonances = true;
  request.resonance_of = [line_of = resonances_by_line(resolved)](const SweepPoint& point) {
    return nearest(line_of(point.settings), point.input_speed);
  };
}

}  // namespace orbearing::app
