// Factors of the life of the bearing of a case, and what `orbearing check` tells of its ratings.
#pragma once

#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/study/static_result.hpp"

namespace orbearing::app {

/// Puts lives and factors into a study whose ratings, equivalent load and reference life are known, and warns
/// where the standard's ranges are left.
void rate(const ResolvedCase& resolved, bearing::rating::RollingElement element, StaticStudy& study);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> static_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
