// Courses through known values: how one participant's outputs become the inputs of another over a window.
#pragma once

#include <vector>

#include "coupling/system/course.hpp"

namespace orbearing::cosim {

/// A value and the time at which it holds.
struct TimedValue {
  double time = 0.0;   // [s]
  double value = 0.0;  // [unit]
};

/// The polynomial of least degree through one to four points, as a course that counts from `begin` [s].
/// Throws std::invalid_argument for another number of points, or two at one time.
Course through(const std::vector<TimedValue>& points, double begin);

/// The cubic with the given values and slopes at both ends of a window of `length` [s].
Course hermite(double value, double slope, double end_value, double end_slope, double length);

/// The slope of a course, as a course.
inline Course slope_of(const Course& course) {
  const auto& c = course.coefficient;
  return {{c[1], 2.0 * c[2], 3.0 * c[3], 0.0}};
}

}  // namespace orbearing::cosim
