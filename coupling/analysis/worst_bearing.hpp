// Bearings of a drivetrain that carry unlike loads: their shortest lives, and the life of the worst one.
#pragma once

#include "coupling/analysis/operating_point.hpp"

namespace orbearing::analysis {

/// The worst of all bearings of a point.
UnlikeBearings unlike_bearings(const PointResult& point);

/// Governing life of the worst bearing [h]: over a revolution of the carrier where that is a body, the
/// shortest where bearings carry unlike loads, else of any bearing. Not a number where the standards give
/// none.
double worst_governing_hours(const PointResult& point);

}  // namespace orbearing::analysis
