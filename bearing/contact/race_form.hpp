// Races that are not round: height of the form at one position, and its slope.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Form of a race at one position.
struct FormAt {
  double height = 0.0;          // [m]      by which the radius is larger
  double slope = 0.0;           // [m/rad]  d(height)/d(angle)
  double rotating_slope = 0.0;  // [m/rad]  the share of what turns with the race: -d(height)/d(race angle)
};

/// Form at `angle` [rad] in the carrier frame of a race that has turned by `race_angle` [rad]: the sum of
/// amplitude cos(order * a + phase), where a is `angle`, less `race_angle` for what turns with the race.
inline FormAt form_at(const std::vector<RaceHarmonic>& form, double angle, double race_angle) {
  FormAt sum;
  for (const RaceHarmonic& wave : form) {
    const double position = wave.order * (wave.rotating ? angle - race_angle : angle) + wave.phase;
    const double slope = -wave.order * wave.amplitude * std::sin(position);
    sum.height += wave.amplitude * std::cos(position);
    sum.slope += slope;
    if (wave.rotating) sum.rotating_slope += slope;
  }
  return sum;
}

/// By how much roller `j` is larger in diameter than stated [m].
inline double diameter_deviation(const Bearing& bearing, std::size_t j) {
  const std::vector<double>& given = bearing.rollers().diameter_deviation;
  return j < given.size() ? given[j] : 0.0;
}

/// Whether races are round and rollers alike: for bearings with rollers.
inline bool is_round(const Bearing& bearing) {
  return bearing.inner.form.empty() && bearing.outer.form.empty() &&
         bearing.rollers().diameter_deviation.empty();
}

/// Whether the bearing repeats itself when the cage turns by one roller pitch: equal rollers,
/// no waves but out-of-roundness.
inline bool every_pitch_alike(const Bearing& bearing) {
  const auto turns = [](const RaceHarmonic& wave) { return wave.rotating; };
  return bearing.rollers().diameter_deviation.empty() &&
         std::none_of(bearing.inner.form.begin(), bearing.inner.form.end(), turns) &&
         std::none_of(bearing.outer.form.begin(), bearing.outer.form.end(), turns);
}

}  // namespace orbearing::bearing
