// Loads of contacts that are cut into laminae: motion/lamina_races.hpp, one roller a lane.
#pragma once

#include "bearing/motion/vectorised/race_load.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Sums over the laminae of both contacts of each roller, d being the approach of a lamina: of d^(10/9), of
/// d^(1/9), and of both times the place and its square.
struct LaminaPackSums {
  PackPair load{}, tip_load{};
  PackPair by_approach{}, mixed{}, by_tip{};
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
                                  const PackPair& tip) {
  LaminaPackSums sums;
  for (int k = 0; k < laminae.count; ++k) {
    const double place = laminae.place[k];
    const PackPair depth = elastic + place * tip - drop_of(laminae, k);
    const PackPair root = only(depth > 0.0, ninth_root(depth));
    const PackPair load = root * depth;
    sums.load += load;
    sums.tip_load += place * load;
    sums.by_approach += root;
    sums.mixed += place * root;
    sums.by_tip += (place * place) * root;
  }
  return sums;
}

/// How much more each contact is approached at x = l/2 where the roller stands at `tip`, the bore at
/// `outer_tip`.
inline PackPair contact_tips(const Pack& tip, const Pack& outer_tip) {
  return {-tip, tip - outer_tip};
}

/// Where the contacts of a pack of rollers stand at the last evaluation, for whoever asks for single laminae.
struct LaminaStand {
  Pack inner_approach{}, outer_approach{}, tip{};  // [m]
};

/// Each roller tilts to where the moments of both contacts balance: Newton's method within a bracket, since
/// the moment out of balance falls with the tilt.
[[gnu::noinline]] inline LaminaPackSums balanced_sums(const BothRaces& race, const PackPair& elastic,
                                                      const Pack& outer_tip, Pack& tip) {
  constexpr int kMostIterations = 60;
  constexpr double kBalance = 1e-12;  // of the loads
  constexpr double kNothing = 1e-9;   // [N]  tip loads that move no roller
  const LaminaConstants& laminae = race.laminae;
  const Pack reach =
      absolute(outer_tip) + larger(elastic.low, Pack{}) + larger(elastic.high, Pack{}) + laminae.deepest;
  Pack low = -reach, high = reach;
  const Pack inner_only = only(~(elastic.high > 0.0), spread(1.0));
  const Pack outer_only = only(~(elastic.low > 0.0), spread(1.0));
  tip = outer_tip * (0.5 + 0.5 * outer_only) * (1.0 - inner_only + inner_only * outer_only);
  LaminaPackSums sums;
  for (int i = 0; i < kMostIterations; ++i) {
    sums = tilted_sums(laminae, elastic, contact_tips(tip, outer_tip));
    const PackPair tip_load = race.stiffness * sums.tip_load, load = race.stiffness * sums.load;
    const PackPair by_tip = kLineExponent * race.stiffness * sums.by_tip;
    const Pack excess = tip_load.low - tip_load.high, stiffness = by_tip.low + by_tip.high;
    const Mask open = absolute(excess) > kBalance * (load.low + load.high) + kNothing;
    if (!any(open)) break;
    low = select(excess > 0.0, tip, low);
    high = select(excess > 0.0, high, tip);
    const Pack newton = tip + excess / larger(stiffness, spread(1e-200));
    const Pack next = select((newton > low) & (newton < high), newton, 0.5 * (low + high));
    tip = select(open, next, tip);
  }
  return sums;
}

/// Load of each contact and its slope by its own elastic approach, the roller tilting. What passes from one
/// race to the other through that tilt is left out: the integrator keeps its order with any matrix, and
/// nothing passes without tilt.
inline LoadSlope lamina_load(const BothRaces& race, const PackApproach& e, const Pack& cosine,
                             const Pack& sine, LaminaStand& stand) {
  const LaminaConstants& laminae = race.laminae;
  stand = {e.value.low, e.value.high, Pack{}};
  const LaminaPackSums sums =
      laminae.upright
          ? upright_sums(laminae, e.value)
          : balanced_sums(race, e.value, laminae.bore_tip_x * cosine + laminae.bore_tip_y * sine, stand.tip);
  const NumberPair share = race.stiffness * (1.0 / laminae.count);
  PackPair slope = sums.by_approach;
  if (!laminae.upright) {
    const PackPair by_tip = race.stiffness * sums.by_tip;
    const Pack both = larger(by_tip.low + by_tip.high, spread(1e-200));
    slope -= race.stiffness * sums.mixed * sums.mixed / both;
  }
  return {share * sums.load, kLineExponent * share * slope};
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
