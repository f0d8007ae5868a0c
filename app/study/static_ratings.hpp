// Factors of the life of the bearing of a case, and what `orbearing check` tells of its ratings.
#pragma once

#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/study/static_result.hpp"

namespace orbearing::app {

/// P, P_0, oil and a_1 of a single bearing, at rest or in time. Throws BadInput where kappa is below the range of
/// a_ISO.
bearing::rating::RatingCondition rating_condition_of(const ResolvedCase& resolved, const bearing::Bearing& bearing);

/// Puts all lives into a study whose loads and ratings are known, and warns where the standard's ranges are left.
void rate(const ResolvedCase& resolved, const bearing::Bearing& bearing, StaticStudy& study);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> static_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
