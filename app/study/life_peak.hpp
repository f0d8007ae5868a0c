// The speed at which a sweep finds the longest life: points that were computed, nothing between them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"
#include "coupling/analysis/peak_search.hpp"

namespace orbearing::app {

using analysis::LivedSpeed;
using analysis::next_speeds;
using analysis::peak_resolution;
using analysis::PeakSearch;
using analysis::position_of_longest_life;
using analysis::SpeedLine;

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
