// The speed at which a sweep finds the longest life: points that were computed, nothing between them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

// Which speeds a sweep adds to its grid until the speed of the longest life is known.

/// A speed at which life was computed.
struct LivedSpeed {
  double rpm = 0.0;     // [rpm]
  double life_h = 0.0;  // [h]  0 where the point failed
};

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
std::vector<double> next_speeds(const std::vector<LivedSpeed>& done, const PeakSearch& search);

/// Peak of life on the grid and, where it was refined, of all points on the line of speeds through the grid's
/// best; with warnings: that it is at an end of the range, next to a failed point, or less accurate than
/// required.
struct FoundPeak {
  LifePeak peak;
  std::vector<std::string> warnings;
};
FoundPeak find_peak(const SweepOutcome& outcome);

// The lives of one bearing side by side, at the point of a run or at the peak of a sweep.

/// As text; empty where no point has a life.
std::string lives_text_of(const ResolvedCase& resolved, const SweepOutcome& outcome);

/// As lives_record(), with `speed_rpm` of the point; null where no point has a life.
nlohmann::ordered_json lives_record_of(const ResolvedCase& resolved, const SweepOutcome& outcome);

// Points that a sweep adds to its grid: those that refine its peak.

/// Makes `request` add points on the line of speeds through the grid's best point until its peak is known.
/// Nothing where fewer than two speeds are swept.
void refine_peak_of(const ResolvedCase& resolved, SweepRequest& request);

}  // namespace orbearing::app
