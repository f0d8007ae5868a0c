// Loads of contacts that are cut into laminae: motion/lamina_races.hpp, one roller a lane.
#pragma once

#include "bearing/motion/vectorised/race_load.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Sums over the laminae of both contacts of each roller, d being the approach of a lamina: of d^(10/9), of
/// d^(1/9), and of both times the place and its square.
struct LaminaPackSums {
  PackPair load{}, end_load{};
  PackPair by_approach{}, mixed{}, by_end_displacement{};
};

inline NumberPair drop_of(const LaminaConstants& laminae, int k) {
  return {laminae.inner_drop[k], laminae.outer_drop[k]};
}

/// No roller tilts: one half of the laminae stands for both.
inline LaminaPackSums upright_sums(const LaminaConstants& laminae, const PackPair& elastic) {
  LaminaPackSums sums;
  for (int k = 0; 2 * k < laminae.count; ++k) {
    const double weight = 2 * k + 1 == laminae.count ? 1.0 : 2.0;
    const PackPair depth = elastic - drop_of(laminae, k);
    const PackPair root = only(depth > 0.0, weight * ninth_root(depth));
    sums.load += root * depth;
    sums.by_approach += root;
  }
  return sums;
}

inline LaminaPackSums tilted_sums(const LaminaConstants& laminae, const PackPair& elastic,
                                  const PackPair& end_displacement) {
  LaminaPackSums sums;
  for (int k = 0; k < laminae.count; ++k) {
    const double position = laminae.position[k];
    const PackPair depth = elastic + position * end_displacement - drop_of(laminae, k);
    const PackPair root = only(depth > 0.0, ninth_root(depth));
    const PackPair load = root * depth;
    sums.load += load;
    sums.end_load += position * load;
    sums.by_approach += root;
    sums.mixed += position * root;
    sums.by_end_displacement += (position * position) * root;
  }
  return sums;
}

/// How much more each contact is approached at x = l/2 where the roller stands at `end_displacement`, the
/// bore at `outer_end_displacement`.
inline PackPair end_displacements(const Pack& end_displacement, const Pack& outer_end_displacement) {
  return {-end_displacement, end_displacement - outer_end_displacement};
}

/// How a pack of rollers stands in its contacts and tilts: motion::LaminaStand, and the rate of the
/// end displacement with its slopes.
struct LaminaStand {
  Pack inner_approach{}, outer_approach{}, end_displacement{};  // [m]
  Pack rate{};                                                  // [m/s]  of the end displacement
  Pack by_end_displacement{}, by_inner{},
      by_outer{};  // [1/s]  its slopes, the latter by the rigid bodies' approaches
};

/// Load of each contact and its slope by its own elastic approach. What the tilt passes from one variable to
/// the loads is left out of the slopes: the integrator keeps its order with any matrix, and the tilt itself
/// is solved for with all of its own (PackEngine::complete_rollers).
inline LoadSlope lamina_load(const RacePair& race, const PackApproach& e, const Pack& cosine,
                             const Pack& sine, LaminaStand& stand) {
  const LaminaConstants& laminae = race.laminae;
  stand.inner_approach = e.value.low;
  stand.outer_approach = e.value.high;
  const NumberPair share = race.stiffness * (1.0 / laminae.count);
  if (laminae.upright) {
    const LaminaPackSums sums = upright_sums(laminae, e.value);
    return {share * sums.load, kLineExponent * share * sums.by_approach};
  }
  const Pack outer_end_displacement = laminae.bore_end_displacement_x * cosine + laminae.bore_end_displacement_y * sine;
  const LaminaPackSums sums =
      tilted_sums(laminae, e.value, end_displacements(stand.end_displacement, outer_end_displacement));
  const NumberPair per_resistance = share * (1.0 / laminae.resistance);
  const PackPair moment = per_resistance * sums.end_load;
  const PackPair by_end_displacement = kLineExponent * per_resistance * sums.by_end_displacement;
  const PackPair mixed = kLineExponent * per_resistance * sums.mixed * e.by_approach;
  stand.rate = moment.low - moment.high;
  stand.by_end_displacement = -(by_end_displacement.low + by_end_displacement.high);
  stand.by_inner = mixed.low;
  stand.by_outer = -mixed.high;
  return {share * sums.load, kLineExponent * share * sums.by_approach};
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
