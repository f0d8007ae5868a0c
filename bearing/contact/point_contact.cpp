#include "bearing/contact/point_contact.hpp"

#include <numbers>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

namespace {

constexpr double kPi = constants::pi;

ContactEllipse ellipse_of(double axis_ratio) {
  const double modulus = std::sqrt(1.0 - 1.0 / (axis_ratio * axis_ratio));
  return {axis_ratio, boost::math::ellint_1(modulus), boost::math::ellint_2(modulus)};
}

// F = 1 - 2/(chi^2 - 1) (K/E - 1), with its limit for a circle.
double difference_of(double axis_ratio) {
  const double excess = axis_ratio * axis_ratio - 1.0;
  constexpr double nearly_circular = 1e-6;
  if (excess < nearly_circular) return 0.25 * excess;
  const ContactEllipse ellipse = ellipse_of(axis_ratio);
  return 1.0 - 2.0 / excess * (ellipse.first / ellipse.second - 1.0);
}

}  // namespace

ContactEllipse contact_ellipse(double curvature_difference) {
  mechanics::require(curvature_difference >= 0.0 && curvature_difference < 1.0,
                     "curvature difference of a point contact [-]", curvature_difference,
                     "at least 0 and less than 1");
  constexpr double circle = 1e-12;
  if (curvature_difference < circle) return ellipse_of(1.0);
  double slenderest = 2.0;
  while (difference_of(slenderest) < curvature_difference) slenderest *= 2.0;
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double ratio) { return difference_of(ratio) - curvature_difference; }, 1.0, slenderest,
      boost::math::tools::eps_tolerance<double>(50), iterations);
  return ellipse_of(0.5 * (low + high));
}

// Q = sqrt(2) pi/3 E' (chi^2 E/Sigma)^(1/2) K^(-3/2) delta^(3/2), as in [ISO16281] with the exact factor.
PointContact point_contact(const PointCurvature& curvature, const Material& material) {
  PointContact contact{.curvature = curvature, .ellipse = contact_ellipse(curvature.difference)};
  const ContactEllipse& ellipse = contact.ellipse;
  contact.modulus = material.plane_strain_modulus();
  contact.constant = std::numbers::sqrt2 * kPi / 3.0 * contact.modulus *
                     std::sqrt(ellipse.axis_ratio * ellipse.axis_ratio * ellipse.second / curvature.sum) *
                     std::pow(ellipse.first, -1.5);
  return contact;
}

PointPressure point_pressure(const PointContact& contact, double load) {
  const ContactEllipse& ellipse = contact.ellipse;
  const double scale = std::cbrt(3.0 * load / (contact.curvature.sum * contact.modulus));  // [m]
  const double mean = 2.0 * ellipse.second / kPi;
  PointPressure result{.major = scale * std::cbrt(mean * ellipse.axis_ratio * ellipse.axis_ratio),
                       .minor = scale * std::cbrt(mean / ellipse.axis_ratio)};
  result.pressure = load > 0.0 ? 1.5 * load / (kPi * result.major * result.minor) : 0.0;
  return result;
}

double load_at_pressure(const PointContact& contact, double pressure) {
  constexpr double unit_load = 1.0;  // [N]  the pressure grows with the cube root of the load
  const double ratio = pressure / point_pressure(contact, unit_load).pressure;
  return unit_load * ratio * ratio * ratio;
}

double in_series(const PointContact& one, const PointContact& other) {
  return std::pow(std::pow(one.constant, -2.0 / 3.0) + std::pow(other.constant, -2.0 / 3.0), -1.5);
}

PointCurvature ball_race_curvature(Race race, double ball_diameter, double pitch_diameter,
                                   double groove_radius, double contact_angle) {
  const double gamma = ball_diameter * std::cos(contact_angle) / pitch_diameter;
  const double along = race == Race::inner ? gamma / (1.0 - gamma) : -gamma / (1.0 + gamma);
  const double across = ball_diameter / (2.0 * groove_radius);
  const double sum = 2.0 + along - across;
  return {.sum = 2.0 / ball_diameter * sum, .difference = (along + across) / sum};
}

}  // namespace orbearing::bearing
