// What a sweep adds to its grid: the points that refine its peak.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

/// Makes `request` add points on the line of speeds through the grid's best point until its peak is known.
/// Nothing where fewer than two speeds are swept.
void refine_peak_of(const ResolvedCase& resolved, SweepRequest& request);

}  // namespace orbearing::app
