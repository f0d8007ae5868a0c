// Warnings of a sweep, beside its numbers.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/life_peak.hpp"

namespace orbearing::app {

/// Warnings of the gears, on inputs without effect, on the peak, on contacts beyond the limits of steel and
/// on motions that did not settle; each names its location.
std::vector<std::string> sweep_warnings(const ResolvedCase& resolved, const SweepOutcome& outcome,
                                        const FoundPeak& found);

}  // namespace orbearing::app
