// Bearings of a drivetrain that carry unlike loads: their shortest lives, and the life of the worst one.
#pragma once

#include <limits>

#include "bearing/life/rating_lives.hpp"

namespace orbearing::study {

struct PointResult;

/// The worst of bearings that carry unlike loads. Not a number where all carry alike.
struct UnlikeBearings {
  static constexpr double kAlike = std::numeric_limits<double>::quiet_NaN();
  double shortest_hours = kAlike;                // [h]  Lundberg and Palmgren
  bearing::rating::RatedHours shortest_rated{};  // [h]  shortest life by life
  double planet = kAlike;                        // with the shortest life, counted from 1
  double load_share = kAlike;                    // [-]  largest of all planets
};
UnlikeBearings unlike_bearings(const PointResult& point);

/// Governing life of the worst bearing [h]: over a revolution of the carrier where that is a body, the
/// shortest where bearings carry unlike loads, else of any bearing. Not a number where the standards give
/// none.
double worst_governing_hours(const PointResult& point);

}  // namespace orbearing::study
