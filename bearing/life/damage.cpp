#include "bearing/life/damage.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/life/lundberg_palmgren.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::motion {

using constants::two_pi;

static_assert(static_cast<double>(DamagePower::of_points) == life::point_contacts.load_exponent &&
              static_cast<double>(DamagePower::of_lines) == life::line_contacts.load_exponent);

namespace {

// bin_of() where a call would cost more than what it does. Whole turns by truncation, since the library's
// floor() is a call, too: the same number.
inline Eigen::Index bin_at(double angle, double bins) {
  const double turns = angle / two_pi + 0.5 / bins;
  double whole = static_cast<double>(static_cast<long long>(turns));
  if (whole > turns) whole -= 1.0;
  const double bin = (turns - whole) * bins;
  return static_cast<Eigen::Index>(std::min(bin, bins - 1.0));
}

}  // namespace

Eigen::Index bin_of(double angle, Eigen::Index bins) {
  return bin_at(angle, static_cast<double>(bins));
}

RaceSpeeds race_speeds(const BearingGeometry& geometry, double inner, double outer) {
  return {inner, outer, kinematic_cage_speed(geometry, inner, outer)};
}

Eigen::Index uneven_laminae(const LaminaRaces* laminae) {
  return laminae && !laminae->even() ? laminae->inner().laminae() : 0;
}

RacePassages::RacePassages(Eigen::Index bins, Eigen::Index laminae, DamagePower damage_power)
    : way(Eigen::ArrayXd::Zero(bins)),
      load(way),
      power(way),
      lamina_fourth_power(Eigen::ArrayXXd::Zero(laminae, laminae > 0 ? bins : 0)),
      damage_power_(damage_power) {}

void RacePassages::add_laminae(Eigen::Index bin, double passed, double force,
                               const Eigen::Ref<const Eigen::ArrayXd>& forces) {
  const double elastic = forces.sum();
  if (!(elastic > 0.0)) return;
  const double damped = force / elastic;
  const double square = damped * damped;
  lamina_fourth_power.col(bin) += (passed * square * square) * forces.square().square();
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

// Adds the laminae of one roller, if it is loaded.
void add_laminae_of(const RollerLoads& loads, Eigen::Index j, Race race, Eigen::Index bin, double passed,
                    Eigen::ArrayXd& forces, RacePassages& sums, RacePassages* others) {
  const double force = (race == Race::inner ? loads.inner : loads.outer)[j];
  if (!(force > 0.0)) return;
  loads.laminae->put_loads(race,
                           {loads.inner_approach[j], loads.outer_approach[j], loads.end_displacement[j]},
                           direction(loads.angle[j]), forces.data());
  sums.add_laminae(bin, passed, force, forces);
  if (others) others->add_laminae(bin, passed, force, forces);
}

}  // namespace

void DamageSums::add(double time, Eigen::Index rollers, const RollerLoads& loads, DamageSums* other) {
  if (other && !(other->inner.is_counted_as(inner))) {
    other->add(time, rollers, loads);
    other = nullptr;
  }
  const RaceSpeeds& races = loads.races;
  const bool cut = inner.lamina_fourth_power.rows() > 0;
  const double bins = static_cast<double>(inner.way.size());
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const Eigen::Index bin = bin_at(loads.angle[j], bins);
    const double on_inner = time * std::abs(loads.orbital_speed[j] - races.inner);
    const double on_outer = time * std::abs(loads.orbital_speed[j] - races.outer);
    const RacePassages::Share to_inner = inner.share_of(on_inner, loads.inner[j]),
                              to_outer = outer.share_of(on_outer, loads.outer[j]);
    inner.add(bin, to_inner);
    outer.add(bin, to_outer);
    if (other) {
      other->inner.add(bin, to_inner);
      other->outer.add(bin, to_outer);
    }
    if (!cut) continue;
    add_laminae_of(loads, j, Race::inner, bin, on_inner, lamina_forces_, inner,
                   other ? &other->inner : nullptr);
    add_laminae_of(loads, j, Race::outer, bin, on_outer, lamina_forces_, outer,
                   other ? &other->outer : nullptr);
  }
  const double all = time * static_cast<double>(rollers);
  for (DamageSums* sums : {this, other}) {
    if (!sums) continue;
    sums->inner.rolling += all * std::abs(races.cage - races.inner);
    sums->outer.rolling += all * std::abs(races.cage - races.outer);
  }
}

life::LaminaMeans means_of(const RaceMotions& motions, const RaceDamageView& inner,
                           const RaceDamageView& outer) {
  if (inner.laminae.rows() > 0) return life::lamina_means(motions, inner.laminae, outer.laminae);
  return life::lamina_means(motions, inner.whole.transpose(), outer.whole.transpose());
}

BearingLife life_under(const Bearing& bearing, double reduction_factor, const RaceDamageView& inner,
                       const RaceDamageView& outer) {
  return life::life_of_means(life::lamina_rating(bearing, reduction_factor),
                             means_of(bearing.motions, inner, outer));
}

BearingLife DamageSums::life(const Bearing& bearing, double reduction_factor) const {
  const RaceDamage of_inner{inner.damage(), inner.lamina_damage()},
      of_outer{outer.damage(), outer.lamina_damage()};
  return life_under(bearing, reduction_factor, of_inner, of_outer);
}

}  // namespace orbearing::bearing::motion
