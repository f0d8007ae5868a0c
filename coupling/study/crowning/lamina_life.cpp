#include "coupling/study/crowning/lamina_life.hpp"

#include <cmath>
#include <limits>

namespace orbearing::study::crowning {

namespace {

namespace rating = bearing::rating;
using bearing::Race;
using bearing::RaceMotion;
using Loads = Eigen::Ref<const Eigen::ArrayXXd>;

constexpr double kWeibullSlope = 9.0 / 8.0;
constexpr double kMillionRevolutions = 1e6;

rating::ContactCapacities capacities_of(const bearing::CylindricalRollerBearing& bearing, LifeMeasure measure,
                                        double lambda) {
  if (measure == LifeMeasure::lundberg_palmgren)
    return {bearing::contact_capacity(bearing, Race::inner, lambda),
            bearing::contact_capacity(bearing, Race::outer, lambda)};
  const rating::RollerSet set = rating::roller_set(bearing);
  return rating::contact_capacities(set, rating::dynamic_capacity(set));
}

Eigen::ArrayXd riser_of(int laminae, LifeMeasure measure) {
  if (measure == LifeMeasure::iso16281) return rating::stress_riser(laminae);
  return Eigen::ArrayXd::Ones(laminae);
}

Eigen::ArrayXd weights(const Eigen::ArrayXd& riser, double capacity) {
  return (riser / rating::lamina_capacity(capacity, static_cast<int>(riser.size()))).pow(4.5);
}

// Mean over the places of the load's power: (2) without its root.
Eigen::ArrayXd mean_power(const Loads& loads, RaceMotion motion) {
  if (motion == RaceMotion::turning) return loads.square().square().rowwise().mean();
  return (loads.square().square() * loads.sqrt()).rowwise().mean();
}

Eigen::ArrayXd damage(const Eigen::ArrayXd& weight, const Eigen::ArrayXd& mean, RaceMotion motion) {
  return motion == RaceMotion::turning ? Eigen::ArrayXd(weight * mean.pow(4.5 / 4.0)) : weight * mean;
}

double life_of(double damage) {
  return damage > 0.0 ? kMillionRevolutions * std::pow(damage, -1.0 / kWeibullSlope)
                      : std::numeric_limits<double>::infinity();
}

// d(damage)/d(load), by the chain damage - mean - load.
Eigen::ArrayXXd damage_slope(const Eigen::ArrayXd& weight, const Loads& loads, const Eigen::ArrayXd& mean,
                             RaceMotion motion) {
  const double places = static_cast<double>(loads.cols());
  if (motion == RaceMotion::standing)
    return (loads.square() * loads * loads.sqrt()).colwise() * (weight * 4.5 / places);
  const Eigen::ArrayXd factor = (mean > 0.0).select(weight * 4.5 / places * mean.pow(0.125), 0.0);
  return (loads.square() * loads).colwise() * factor;
}

}  // namespace

std::string name_of(LifeMeasure measure) {
  return measure == LifeMeasure::iso16281 ? "iso16281" : "lundberg-palmgren";
}

LaminaRating lamina_rating(const bearing::CylindricalRollerBearing& bearing,
                           const bearing::OperatingPoint& point, LifeMeasure measure, double lambda) {
  const rating::ContactCapacities capacities = capacities_of(bearing, measure, lambda);
  const Eigen::ArrayXd riser = riser_of(bearing.laminae, measure);
  const auto motion = [](double speed) { return speed != 0.0 ? RaceMotion::turning : RaceMotion::standing; };
  return {weights(riser, capacities.inner),
          weights(riser, capacities.outer),
          {motion(point.inner_speed), motion(point.outer_speed)}};
}

bearing::BearingLife lamina_life(const LaminaRating& rating, const Loads& inner, const Loads& outer) {
  const double of_inner =
      damage(rating.inner_weight, mean_power(inner, rating.motions.inner), rating.motions.inner).sum();
  const double of_outer =
      damage(rating.outer_weight, mean_power(outer, rating.motions.outer), rating.motions.outer).sum();
  return {life_of(of_inner), life_of(of_outer), life_of(of_inner + of_outer)};
}

LogLife log_life(const LaminaRating& rating, const Loads& inner, const Loads& outer) {
  const Eigen::ArrayXd inner_mean = mean_power(inner, rating.motions.inner);
  const Eigen::ArrayXd outer_mean = mean_power(outer, rating.motions.outer);
  const double all = damage(rating.inner_weight, inner_mean, rating.motions.inner).sum() +
                     damage(rating.outer_weight, outer_mean, rating.motions.outer).sum();
  const double by_damage = all > 0.0 ? -1.0 / (kWeibullSlope * all) : 0.0;
  return {std::log(life_of(all)),
          by_damage * damage_slope(rating.inner_weight, inner, inner_mean, rating.motions.inner),
          by_damage * damage_slope(rating.outer_weight, outer, outer_mean, rating.motions.outer)};
}

}  // namespace orbearing::study::crowning
