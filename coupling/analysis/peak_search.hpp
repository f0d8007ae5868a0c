// Which speeds a sweep adds to its grid until the speed of the longest life is known.
#pragma once

#include <cstddef>
#include <vector>

namespace orbearing::analysis {

/// A speed at which life was computed.
struct LivedSpeed {
  double rpm = 0.0;     // [rpm]
  double life_h = 0.0;  // [h]  0 where the point failed
};

using SpeedLine = std::vector<LivedSpeed>;  // in one line of a sweep, ascending

/// Position of the longest life.
std::size_t position_of_longest_life(const SpeedLine& line);

/// Expected shape of the curve of life.
struct PeakSearch {
  /// Life by motion in time: it dips where the gears resonate, so that there may be several maxima, and is
  /// repeatable only to about one percent. Otherwise it is smooth.
  bool in_motion = false;
  std::vector<double> resonances_rpm;  // [rpm]  where dips are expected
};

/// Largest distance of its neighbours at which the speed of the peak is known [rpm]: 10 rpm in motion and 2
/// rpm otherwise, at low speeds a two-hundredth or a thousandth of the speed.
double peak_resolution(double rpm, bool in_motion);

/// The speeds [rpm] to be computed next, ascending, when those of `done` are (ascending; in one line of a
/// sweep). None where the peak is known: the longest life has a neighbour within `peak_resolution` on each
/// side, or is at an end of the range; and no unresolved interval remains in which a curve with resonances
/// could rise above it (docs/peak.md). Depends on its arguments alone; never leaves the range of `done`.
std::vector<double> next_speeds(const SpeedLine& done, const PeakSearch& search);

}  // namespace orbearing::analysis
