// Polynomials through known values: how one participant's outputs become the inputs of another over a window.
#pragma once

#include <vector>

#include "coupling/system/input_polynomial.hpp"

namespace orbearing::cosim {

using system::InputPolynomial;

/// A value and the time at which it holds.
struct TimedValue {
  double time = 0.0;   // [s]
  double value = 0.0;  // [unit]
};

/// The polynomial of least degree through one to four points; it counts from `begin` [s].
/// Throws std::invalid_argument for another number of points, or two at one time.
InputPolynomial through(const std::vector<TimedValue>& points, double begin);

/// The cubic with the given values and slopes at both ends of a window of `length` [s].
InputPolynomial hermite(double value, double slope, double end_value, double end_slope, double length);

/// The slope of a polynomial.
inline InputPolynomial slope_of(const InputPolynomial& polynomial) {
  const auto& c = polynomial.coefficient;
  return {{c[1], 2.0 * c[2], 3.0 * c[3], 0.0}};
}

}  // namespace orbearing::cosim
