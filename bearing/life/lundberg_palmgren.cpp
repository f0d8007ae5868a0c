#include "bearing/life/lundberg_palmgren.hpp"
#include "mechanics/constants.hpp"

#include <cmath>

namespace orbearing::bearing {

double contact_capacity(const Bearing& bearing, Race race, double reduction_factor) {
  const CylindricalRollers& rollers = bearing.rollers();
  const double gamma = slenderness(bearing);
  const double side = race == Race::inner ? -gamma : gamma;
  const double diameter_mm = 1e3 * rollers.diameter;
  const double length_mm = 1e3 * rollers.length;
  return 552.0 * reduction_factor * std::pow(1.0 + side, 29.0 / 27.0) / std::pow(1.0 - side, 0.25) *
         std::pow(gamma, 2.0 / 9.0) * std::pow(diameter_mm, 29.0 / 27.0) * std::pow(length_mm, 7.0 / 9.0) *
         std::pow(rollers.count, -0.25);
}

double combined_life(double inner, double outer) {
  return rating::system_life(Eigen::Array2d(inner, outer), life::line_contacts.weibull_slope);
}

double system_life(double one_bearing, int n) {
  return one_bearing * std::pow(n, -1.0 / life::line_contacts.weibull_slope);
}

double hours(double revolutions, double speed) {
  const double revolutions_per_hour = std::abs(speed) * 3600.0 / constants::two_pi;
  return revolutions_per_hour > 0.0 ? revolutions / revolutions_per_hour : kInfinity;
}

}  // namespace orbearing::bearing
