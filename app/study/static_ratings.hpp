// Standard ratings of the bearing of a case: capacities, factors, and lives from a distribution of loads.
#pragma once

#include "app/study/static_study.hpp"

namespace orbearing::app {

/// Puts lives and factors into a study whose ratings, equivalent load and reference life are known, and warns
/// where the standard's ranges are left.
void rate(const ResolvedCase& resolved, bearing::rating::RollingElement element, StaticStudy& study);

}  // namespace orbearing::app
