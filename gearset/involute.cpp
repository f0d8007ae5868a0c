#include "gearset/involute.hpp"
#include "mechanics/constants.hpp"

#include <boost/math/tools/roots.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace orbearing::gearset {

namespace {

// tan(a) - a loses digits by cancellation below this angle, where the series is exact to round-off.
constexpr double series_limit = 0.05;  // [rad]

double involute_series(double angle) {
  const double a2 = angle * angle;
  const double tail = 62.0 / 2835.0 + a2 * (1382.0 / 155925.0 + a2 * (21844.0 / 6081075.0));
  return angle * a2 * (1.0 / 3.0 + a2 * (2.0 / 15.0 + a2 * (17.0 / 315.0 + a2 * tail)));
}

// Exact to leading order at both ends: inv(a) -> a^3/3 for small a, and a -> pi/2 - 1/inv(a) for large
// inv(a).
double initial_guess(double value) {
  return value < 1.0 ? std::cbrt(3.0 * value) / (1.0 + 0.4 * std::cbrt(value * value))
                     : std::atan(value + constants::pi / 2.0 - 1.0 / (value + 1.0));
}

}  // namespace

double involute(double pressure_angle) {
  assert(pressure_angle >= 0.0 && pressure_angle < constants::pi / 2.0);
  return pressure_angle < series_limit ? involute_series(pressure_angle)
                                       : std::tan(pressure_angle) - pressure_angle;
}

double inverse_involute(double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) {
    throw std::domain_error("the involute of a pressure angle is a finite number not below zero; change teeth or shifts");
  }
  if (value == 0.0) return 0.0;
  const auto residual_and_slope = [value](double angle) {
    const double slope = std::tan(angle);
    return std::make_pair(involute(angle) - value, slope * slope);
  };
  constexpr double upper =
      constants::pi / 2.0 * (1.0 - std::numeric_limits<double>::epsilon());
  std::uintmax_t iterations = 100;
  return boost::math::tools::newton_raphson_iterate(residual_and_slope, initial_guess(value), 0.0, upper,
                                                    std::numeric_limits<double>::digits - 2, iterations);
}

double pressure_angle_at(double base_radius, double radius) {
  return std::atan2(tangent_length(base_radius, radius), base_radius);
}

double tangent_length(double base_radius, double radius) {
  assert(radius >= base_radius && base_radius > 0.0);
  return std::sqrt((radius - base_radius) * (radius + base_radius));
}

}  // namespace orbearing::gearset
