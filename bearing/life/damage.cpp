#include "bearing/life/damage.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/life/lamina_life.hpp"

namespace orbearing::bearing::motion {

using boost::math::double_constants::two_pi;

Eigen::Index place_of(double angle, Eigen::Index places) {
  const double turns = angle / two_pi + 0.5 / static_cast<double>(places);
  const auto place = static_cast<Eigen::Index>((turns - std::floor(turns)) * static_cast<double>(places));
  return std::min(place, places - 1);
}

RaceSpeeds race_speeds(const BearingGeometry& geometry, double inner, double outer) {
  return {inner, outer, kinematic_cage_speed(geometry, inner, outer)};
}

Eigen::Index uneven_laminae(const LaminaRaces* laminae) {
  return laminae && !laminae->even() ? laminae->inner().laminae() : 0;
}

RacePassages::RacePassages(Eigen::Index places, Eigen::Index laminae, DamagePower damage_power)
    : way(Eigen::ArrayXd::Zero(places)),
      load(way),
      power(way),
      lamina_fourth_power(Eigen::ArrayXXd::Zero(laminae, laminae > 0 ? places : 0)),
      damage_power_(damage_power) {}

void RacePassages::add(Eigen::Index place, double passed, double force) {
  const double square = force * force;
  way[place] += passed;
  load[place] += passed * force;
  power[place] += passed * square * (damage_power_ == DamagePower::of_points ? force : square);
}

void RacePassages::add_laminae(Eigen::Index place, double passed, double force,
                               const Eigen::Ref<const Eigen::ArrayXd>& forces) {
  const double elastic = forces.sum();
  if (!(elastic > 0.0)) return;
  const double damped = force / elastic;
  const double square = damped * damped;
  lamina_fourth_power.col(place) += (passed * square * square) * forces.square().square();
  lamina_largest = std::max(lamina_largest, damped * forces.maxCoeff());
}

Eigen::ArrayXXd RacePassages::over_rolling(const Eigen::Ref<const Eigen::ArrayXXd>& sums) const {
  if (rolling <= 0.0) return Eigen::ArrayXXd::Zero(sums.rows(), sums.cols());
  return sums * (static_cast<double>(way.size()) / rolling);
}

Eigen::ArrayXd RacePassages::passages() const {
  return over_rolling(way);
}

Eigen::ArrayXd RacePassages::mean_load() const {
  return load / (way > 0.0).select(way, 1.0);
}

Eigen::ArrayXd RacePassages::damage() const {
  return over_rolling(power);
}

Eigen::ArrayXXd RacePassages::lamina_damage() const {
  return over_rolling(lamina_fourth_power);
}

namespace {

// Of one roller, where it is loaded.
void add_laminae_of(const RollerLoads& loads, Eigen::Index j, Race race, Eigen::Index place, double passed,
                    Eigen::ArrayXd& forces, RacePassages& sums) {
  const double force = (race == Race::inner ? loads.inner : loads.outer)[j];
  if (!(force > 0.0)) return;
  loads.laminae->put_loads(race, {loads.inner_approach[j], loads.outer_approach[j], loads.tip[j]},
                           direction(loads.angle[j]), forces.data());
  sums.add_laminae(place, passed, force, forces);
}

}  // namespace

void DamageSums::add(double time, Eigen::Index rollers, const RollerLoads& loads) {
  const RaceSpeeds& races = loads.races;
  const bool cut = inner.lamina_fourth_power.rows() > 0;
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const Eigen::Index place = place_of(loads.angle[j], inner.way.size());
    const double on_inner = time * std::abs(loads.orbital_speed[j] - races.inner);
    const double on_outer = time * std::abs(loads.orbital_speed[j] - races.outer);
    inner.add(place, on_inner, loads.inner[j]);
    outer.add(place, on_outer, loads.outer[j]);
    if (!cut) continue;
    add_laminae_of(loads, j, Race::inner, place, on_inner, lamina_forces_, inner);
    add_laminae_of(loads, j, Race::outer, place, on_outer, lamina_forces_, outer);
  }
  const double all = time * static_cast<double>(rollers);
  inner.rolling += all * std::abs(races.cage - races.inner);
  outer.rolling += all * std::abs(races.cage - races.outer);
}

BearingLife life_under(const Bearing& bearing, double lambda, const RaceDamage& inner,
                       const RaceDamage& outer) {
  if (inner.laminae.rows() == 0)
    return lundberg_palmgren_life(bearing, lambda, inner.whole.pow(0.25), outer.whole.pow(0.25));
  const life::LaminaRating rating =
      life::lamina_rating(bearing, life::LifeMeasure::lundberg_palmgren, lambda);
  return life_of_fourth_powers(rating, inner.laminae, outer.laminae);
}

BearingLife DamageSums::life(const Bearing& bearing, double lambda) const {
  return life_under(bearing, lambda, {inner.damage(), inner.lamina_damage()},
                    {outer.damage(), outer.lamina_damage()});
}

}  // namespace orbearing::bearing::motion
