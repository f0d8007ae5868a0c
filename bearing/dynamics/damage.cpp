#include "bearing/dynamics/damage.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace orbearing::bearing::dynamics {

using boost::math::double_constants::two_pi;

Eigen::Index place_of(double angle, Eigen::Index places) {
  const double turns = angle / two_pi + 0.5 / static_cast<double>(places);
  const auto place = static_cast<Eigen::Index>((turns - std::floor(turns)) * static_cast<double>(places));
  return std::min(place, places - 1);
}

RaceSpeeds race_speeds(const RollerBearingGeometry& geometry, double inner, double outer) {
  return {inner, outer, kinematic_cage_speed(geometry, inner, outer)};
}

RacePassages::RacePassages(Eigen::Index places)
    : way(Eigen::ArrayXd::Zero(places)), load(way), fourth_power(way) {}

void RacePassages::add(Eigen::Index place, double passed, double force) {
  const double square = force * force;
  way[place] += passed;
  load[place] += passed * force;
  fourth_power[place] += passed * square * square;
}

Eigen::ArrayXd RacePassages::over_rolling(const Eigen::ArrayXd& sums) const {
  if (rolling <= 0.0) return Eigen::ArrayXd::Zero(sums.size());
  return sums * (static_cast<double>(sums.size()) / rolling);
}

Eigen::ArrayXd RacePassages::passages() const {
  return over_rolling(way);
}

Eigen::ArrayXd RacePassages::mean_load() const {
  return load / (way > 0.0).select(way, 1.0);
}

Eigen::ArrayXd RacePassages::damage() const {
  return over_rolling(fourth_power);
}

void DamageSums::add(double time, Eigen::Index rollers, const RollerLoads& loads) {
  const RaceSpeeds& races = loads.races;
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const Eigen::Index place = place_of(loads.angle[j], inner.way.size());
    inner.add(place, time * std::abs(loads.orbital_speed[j] - races.inner), loads.inner[j]);
    outer.add(place, time * std::abs(loads.orbital_speed[j] - races.outer), loads.outer[j]);
  }
  const double all = time * static_cast<double>(rollers);
  inner.rolling += all * std::abs(races.cage - races.inner);
  outer.rolling += all * std::abs(races.cage - races.outer);
}

BearingLife life_under(const CylindricalRollerBearing& bearing, double lambda, Race standing,
                       const Eigen::Ref<const Eigen::ArrayXd>& inner_damage,
                       const Eigen::Ref<const Eigen::ArrayXd>& outer_damage) {
  return lundberg_palmgren_life(bearing, lambda, standing, inner_damage.pow(0.25), outer_damage.pow(0.25));
}

BearingLife DamageSums::life(const CylindricalRollerBearing& bearing, double lambda, Race standing) const {
  return life_under(bearing, lambda, standing, inner.damage(), outer.damage());
}

}  // namespace orbearing::bearing::dynamics
