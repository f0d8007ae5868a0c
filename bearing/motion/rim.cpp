#include "bearing/motion/rim.hpp"

#include <algorithm>

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

RimModel rim_model(const ElasticRace& race, const RimParameters& parameters) {
  RimModel rim;
  if (race.is_rigid()) return rim;
  mechanics::require(parameters.damping_ratio >= 0.0, "damping ratio of a rim", parameters.damping_ratio,
                     "0 or more");
  mechanics::require(race.mass.size() == race.compliance.size(), "masses of the waves of an elastic race",
                     static_cast<double>(race.mass.size()), "one for each order of a race in motion");
  for (Eigen::Index order = 0; order < race.mass.size(); ++order)
    if (order != 1)
      mechanics::require(race.mass[order] > 0.0, "mass of a wave of an elastic race [kg]", race.mass[order],
                         "more than 0");
  rim.stiffness = wave_stiffness(race);
  rim.mass = waves_of_orders(race, race.mass);
  rim.damping = 2.0 * parameters.damping_ratio * rim.stiffness.cwiseProduct(rim.mass).cwiseSqrt();
  rim.at_rest = waves_at_rest(race);
  return rim;
}

}  // namespace orbearing::bearing::motion
