// A quantity over one window of time, as a polynomial.
#pragma once

#include <array>

namespace orbearing::cosim {

/// value(s) = c0 + c1 s + c2 s^2 + c3 s^3, with s [s] the time since the beginning of the window.
struct Course {
  std::array<double, 4> coefficient{};  // [unit], [unit/s], [unit/s^2], [unit/s^3]

  static Course constant(double value) { return {{value, 0.0, 0.0, 0.0}}; }

  double at(double since) const {
    const auto& c = coefficient;
    return c[0] + since * (c[1] + since * (c[2] + since * c[3]));
  }
  /// By time [unit/s].
  double slope(double since) const {
    const auto& c = coefficient;
    return c[1] + since * (2.0 * c[2] + since * 3.0 * c[3]);
  }
  /// The same polynomial, of a window that begins `later` [s].
  Course moved(double later) const {
    const auto& c = coefficient;
    return {{at(later), slope(later), c[2] + 3.0 * later * c[3], c[3]}};
  }
};

/// `start` + the integral of `rate` from the beginning of the window; `rate` of degree 2 at most.
inline Course integral(double start, const Course& rate) {
  const auto& c = rate.coefficient;
  return {{start, c[0], c[1] / 2.0, c[2] / 3.0}};
}

}  // namespace orbearing::cosim
