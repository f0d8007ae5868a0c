#include "bearing/motion/rim.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::motion {

ElasticRace moving_waves(ElasticRace race, const RimParameters& parameters) {
  if (race.is_rigid()) return race;
  mechanics::require(parameters.most_order >= 0, "largest order of the waves of a rim", parameters.most_order,
                     "0 or more");
  const Eigen::Index orders = std::min<Eigen::Index>(race.compliance.size(), parameters.most_order + 1);
  for (Eigen::ArrayXd* of_orders : {&race.compliance, &race.cosine, &race.sine, &race.mass})
    of_orders->conservativeResize(std::min(orders, of_orders->size()));
  return race;
}

std::vector<vectorised::RimWave> rim_waves(const ElasticRace& race, const RimParameters& parameters) {
  if (race.is_rigid()) return {};
  mechanics::require(parameters.damping_ratio >= 0.0, "damping ratio of a rim", parameters.damping_ratio,
                     "0 or more");
  mechanics::require(race.mass.size() == race.compliance.size(), "masses of the waves of an elastic race",
                     static_cast<double>(race.mass.size()), "one for each order of a race in motion");
  for (Eigen::Index order = 0; order < race.mass.size(); ++order)
    if (order != 1)
      mechanics::require(race.mass[order] > 0.0, "mass of a wave of an elastic race [kg]", race.mass[order],
                         "more than 0");
  const Eigen::VectorXd stiffness = wave_stiffness(race), mass = waves_of_orders(race, race.mass),
                        at_rest = waves_at_rest(race);
  std::vector<vectorised::RimWave> waves;
  for (Eigen::Index i = 0; i < stiffness.size(); ++i)
    waves.push_back({.stiffness = stiffness[i],
                     .mass = mass[i],
                     .damping = 2.0 * parameters.damping_ratio * std::sqrt(stiffness[i] * mass[i]),
                     .at_rest = at_rest[i]});
  return waves;
}

}  // namespace orbearing::bearing::motion
