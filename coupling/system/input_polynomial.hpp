// Windows of time, quantities over one as polynomials, and states that are kept from one to the next.
#pragma once

#include <array>
#include <vector>

#include "bearing/motion/bore_motion.hpp"

namespace orbearing::system {

/// A window of time. Window k of length h begins at k h: times are multiplied, never added up.
struct Window {
  double begin = 0.0;  // [s]
  double end = 0.0;    // [s]

  double length() const { return end - begin; }
};

/// All that the future of a participant depends on. Numbers only, whose meaning is its own; equal bits
/// give equal futures, in another process too.
using SavedState = std::vector<double>;

/// value(s) = c0 + c1 s + c2 s^2 + c3 s^3, with s [s] the time since the beginning of the window.
struct InputPolynomial {
  std::array<double, 4> coefficient{};  // [unit], [unit/s], [unit/s^2], [unit/s^3]

  static InputPolynomial constant(double value) { return {{value, 0.0, 0.0, 0.0}}; }

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
  InputPolynomial moved(double later) const {
    const auto& c = coefficient;
    return {{at(later), slope(later), c[2] + 3.0 * later * c[3], c[3]}};
  }
};

/// `start` + the integral of `rate` from the beginning of the window; `rate` of degree 2 at most.
inline InputPolynomial integral(double start, const InputPolynomial& rate) {
  const auto& c = rate.coefficient;
  return {{start, c[0], c[1] / 2.0, c[2] / 3.0}};
}

/// The slope of a polynomial.
inline InputPolynomial slope_of(const InputPolynomial& polynomial) {
  const auto& c = polynomial.coefficient;
  return {{c[1], 2.0 * c[2], 3.0 * c[3], 0.0}};
}

/// The cubic with the given values and slopes at both ends of a window of `length` [s].
inline InputPolynomial hermite(double value, double slope, double end_value, double end_slope,
                               double length) {
  const double mean = (end_value - value) / length;
  return {{value, slope, (3.0 * mean - 2.0 * slope - end_slope) / length,
           (slope + end_slope - 2.0 * mean) / (length * length)}};
}

/// Motion of the bore of a bearing, and of its carrier, over a window.
struct BoreInputs {
  InputPolynomial x, y;                  // [m]
  InputPolynomial v_x, v_y;              // [m/s]  slopes of the above
  InputPolynomial speed;                 // [rad/s]  of the bore, relative to the carrier
  InputPolynomial carrier_speed;         // [rad/s]
  InputPolynomial carrier_acceleration;  // [rad/s^2]

  /// All but the angles of bore and carrier, which the bearing itself sums up.
  bearing::motion::BoreMotion at(double since) const {
    bearing::motion::BoreMotion motion;
    motion.position = {x.at(since), y.at(since)};
    motion.velocity = {v_x.at(since), v_y.at(since)};
    motion.acceleration = {v_x.slope(since), v_y.slope(since)};
    motion.speed = speed.at(since);
    motion.carrier_speed = carrier_speed.at(since);
    motion.carrier_acceleration = carrier_acceleration.at(since);
    return motion;
  }
};

}  // namespace orbearing::system
