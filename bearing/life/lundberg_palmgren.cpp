#include "bearing/life/lundberg_palmgren.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/life/basic_life.hpp"
#include "bearing/units.hpp"

namespace orbearing::bearing {

namespace {
constexpr double kWeibullSlope = rating::weibull_slope(rating::RollingElement::roller);
}  // namespace

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

double equivalent_load(const Eigen::Ref<const Eigen::ArrayXd>& loads, RaceMotion motion) {
  const double exponent = motion == RaceMotion::turning ? 4.0 : 4.5;
  const double largest = loads.size() > 0 ? loads.maxCoeff() : 0.0;
  if (largest <= 0.0) return 0.0;
  return largest * std::pow((loads / largest).pow(exponent).mean(), 1.0 / exponent);
}

double race_life(double capacity, double equivalent_load) {
  if (equivalent_load <= 0.0) return kInfinity;
  return kMillionRevolutions * std::pow(capacity / equivalent_load, 4.0);
}

double combined_life(double inner, double outer) {
  return std::pow(std::pow(inner, -kWeibullSlope) + std::pow(outer, -kWeibullSlope), -1.0 / kWeibullSlope);
}

double system_life(double one_bearing, int n) {
  return one_bearing * std::pow(n, -1.0 / kWeibullSlope);
}

BearingLife lundberg_palmgren_life(const Bearing& bearing, double reduction_factor,
                                   const Eigen::Ref<const Eigen::ArrayXd>& inner_loads,
                                   const Eigen::Ref<const Eigen::ArrayXd>& outer_loads) {
  const auto life_of = [&](Race race, const Eigen::Ref<const Eigen::ArrayXd>& loads) {
    return race_life(contact_capacity(bearing, race, reduction_factor),
                     equivalent_load(loads, bearing.motion(race)));
  };
  const double inner = life_of(Race::inner, inner_loads);
  const double outer = life_of(Race::outer, outer_loads);
  return {inner, outer, combined_life(inner, outer)};
}

double hours(double revolutions, double speed) {
  const double revolutions_per_hour = std::abs(speed) * 3600.0 / boost::math::double_constants::two_pi;
  return revolutions_per_hour > 0.0 ? revolutions / revolutions_per_hour : kInfinity;
}

}  // namespace orbearing::bearing
