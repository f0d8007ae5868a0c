// The involute function and what follows from it.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <limits>

namespace orbearing::gearset {

// Zero of a function between two points of opposite sign.

/// Zero of a continuous function that changes sign on [low, high], to round-off.
template <typename Function>
double bracketed_root(const Function& function, double low, double high) {
  std::uintmax_t iterations = 200;
  const boost::math::tools::eps_tolerance<double> tolerance(std::numeric_limits<double>::digits - 2);
  const auto [below, above] = boost::math::tools::toms748_solve(function, low, high, tolerance, iterations);
  return 0.5 * (below + above);
}

/// inv(alpha) = tan(alpha) - alpha, accurate to round-off also at small angles. Eq. (1) of gearset/README.md.
/// @param pressure_angle [rad] in [0, pi/2)
/// @return [rad]
double involute(double pressure_angle);

/// The pressure angle whose involute is given.
/// @param value [rad] not negative
/// @return [rad] in [0, pi/2)
/// @throws std::domain_error if value is negative or not finite
double inverse_involute(double value);

/// Pressure angle of an involute at a radius.
/// @param base_radius [m]
/// @param radius      [m] not below the base radius
/// @return [rad]
double pressure_angle_at(double base_radius, double radius);

/// Length of the tangent from a point at `radius` to the base circle: the radius of curvature of the
/// involute.
/// @param base_radius [m]
/// @param radius      [m] not below the base radius
/// @return [m]
double tangent_length(double base_radius, double radius);

}  // namespace orbearing::gearset
