// Elastic load of a race contact with its oil film, and its slopes: bearing/contact/film_law.hpp for packs of
// contacts.
#pragma once

#include "bearing/motion/vectorised/constants.hpp"
#include "mechanics/packs/pack.hpp"
#include "mechanics/packs/powers.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

// The constants of both races side by side, as the laws of race_contact read them: inner low, outer high.

using namespace mechanics::ORBEARING_PACKS;

struct RacePair : RaceNumbers<NumberPair> {
  bool film = false;      // adds to the elastic approach
  bool squeezed = false;  // resists the approach
  FrictionLaws<NumberPair> friction;
  bool round = true;  // neither race has waves or scratches, no roller a scratch, and the outer one is rigid
  int rim_waves = 0;  // of the outer race
  const RaceConstants* inner = nullptr;
  const RaceConstants* outer = nullptr;
  LaminaConstants laminae;
  Listed<RollerScratch> roller_scratches;
};

/// The numbers of both races side by side. Constants hold nothing but numbers.
template <template <class> class Constants>
void put_side_by_side(const Constants<double>& inner, const Constants<double>& outer,
                      Constants<NumberPair>& both) {
  constexpr int kNumbers = sizeof(Constants<double>) / sizeof(double);
  static_assert(sizeof inner == kNumbers * sizeof(double) && sizeof both == kNumbers * sizeof(NumberPair));
  double low[kNumbers], high[kNumbers];
  NumberPair pair[kNumbers];
  __builtin_memcpy(low, &inner, sizeof low);
  __builtin_memcpy(high, &outer, sizeof high);
  for (int i = 0; i < kNumbers; ++i) pair[i] = {low[i], high[i]};
  __builtin_memcpy(&both, pair, sizeof pair);
}

/// Both races follow the same laws, with numbers of their own. Keeps pointers to the constants of both races
/// and to what those of laminae and scratches point to.
inline RacePair race_pair(const Constants& constants) {
  const RaceConstants &inner = constants.inner, &outer = constants.outer;
  RacePair both;
  put_side_by_side<RaceNumbers>(inner, outer, both);
  put_side_by_side<FrictionNumbers>(inner.friction, outer.friction, both.friction);
  static_cast<FrictionChoice&>(both.friction) = inner.friction;
  both.film = inner.film;
  both.squeezed = inner.squeezed;
  both.round = inner.form.empty() && outer.form.empty() && inner.scratches.empty() &&
               outer.scratches.empty() && constants.roller_scratches.empty() && constants.rim.empty();
  both.rim_waves = constants.rim.count;
  both.inner = &inner;
  both.outer = &outer;
  both.laminae = constants.laminae;
  both.roller_scratches = constants.roller_scratches;
  return both;
}

using namespace mechanics::ORBEARING_PACKS;

/// Root e of e - factor e^(-13/90) = approach, with film = factor e^(-13/90) and ninth = e^(1/9).
struct LoadedFilm {
  PackPair approach;
  PackPair film;
  PackPair ninth;
};

/// The powers of x that loaded_film() needs, by multiplication.
struct NinetiethPowers {
  PackPair tenth;       // x^10
  PackPair thirteenth;  // x^13
  PackPair ninetieth;   // x^90

  explicit NinetiethPowers(const PackPair& x) {
    const PackPair x2 = x * x, x4 = x2 * x2;
    tenth = (x4 * x) * (x4 * x);
    thirteenth = tenth * (x2 * x);
    const PackPair x20 = tenth * tenth, x40 = x20 * x20;
    ninetieth = (x40 * x40) * tenth;
  }
};

/// x with x^90 = e for 1e-12 < e < 1, to a few per cent of e.
inline PackPair rough_ninetieth_root(const PackPair& e) {
  constexpr double kLog2 = 0.6931471805599453 / 90.0, kMiddle = -0.16, kRoot = 0.85214378896621133;
  const PackPair t = (rough_log2(e) + 0.043) * kLog2 - kMiddle;
  return kRoot * (1.0 + t * (1.0 + t * (0.5 + t * (1.0 / 6))));
}

/// With e = x^90 all powers are whole ones: x^90 - factor x^-13 = approach. A start within some per cent,
/// then steps of Halley in x; `beyond` is a bound of e from above.
inline LoadedFilm loaded_film(const PackPair& approach, const PackPair& factor, const PackPair& beyond) {
  constexpr double m = 13.0 / 90.0, kRough = 0.97;  // of a rough power, which is never too small
  constexpr double kLargest = 0.02, kNear = 2e-6;   // of steps; after the latter round-off is left
  PackPair e = larger(approach + factor * (kRough * rough_power(beyond, -m)), 0.1 * beyond);
  e = larger(approach + factor * (kRough * rough_power(e, -m)), 0.5 * e);
  PackPair x = rough_ninetieth_root(e);
  for (int i = 0; i < 6; ++i) {
    const NinetiethPowers powers(x);
    // f = e - film - approach, x f' and x^2 f'' / 2, all times x^13.
    const PackPair squeezed = powers.ninetieth * powers.thirteenth;
    const PackPair value = squeezed - factor - approach * powers.thirteenth;
    const PackPair slope = 90.0 * squeezed + 13.0 * factor;
    const PackPair half_bend = 4005.0 * squeezed - 91.0 * factor;
    const PackPair step = value * slope / (slope * slope - value * half_bend);
    x = x * (1.0 - smaller(larger(step, spread<PackPair>(-kLargest)), spread<PackPair>(kLargest)));
    if (i > 0 && !any(absolute(step) > kNear)) break;
  }
  const NinetiethPowers powers(x);
  return {powers.ninetieth, powers.ninetieth - approach, powers.tenth};
}

/// Elastic approach of a contact in the middle and its slopes.
struct PackApproach {
  PackPair value;         // [m]  zero or negative without contact
  PackPair ninth;         // [m^(1/9)]  its ninth root, where it is positive
  PackPair by_approach;   // [-]
  PackPair by_log_speed;  // [m]  by ln u
};

/// As bearing::elastic_approach of contact/film_law.hpp, for the film that is a power law: by whole powers,
/// without a logarithm in each step. With that search instead, the right-hand side takes 1.7 times as long,
/// the slopes 1.4.
template <bool WithSlopes>
PackApproach power_film_approach(const RacePair& race, const PackPair& approach, const PackPair& log_speed) {
  using Film = FilmLaw<NumberPair>;
  // Powers of the entrainment speed by its 29th root: cap ~ u^(19/29), its approach ~ u^(9/29), factor ~
  // u^0.7.
  constexpr double m = Film::kLoad * LineLaw::kExponent;
  constexpr double kOff = 1e-14;
  static_assert(m - 13.0 / 90.0 < kOff && 13.0 / 90.0 - m < kOff);
  static_assert(Film::kCapSpeed - 19.0 / 29.0 < kOff && 19.0 / 29.0 - Film::kCapSpeed < kOff);
  static_assert(LineLaw::kApproachExponent * Film::kCapLoadSpeed - 9.0 / 29.0 < kOff &&
                9.0 / 29.0 - LineLaw::kApproachExponent * Film::kCapLoadSpeed < kOff);
  const PackPair root29 = exponential(log_speed * (1.0 / 29.0));
  const PackPair p2 = root29 * root29, p4 = p2 * p2, p8 = p4 * p4;
  const PackPair cap = race.film_cap * (p8 * p8 * p2 * root29);
  const PackPair cap_approach = race.film_cap_approach * (p8 * root29);
  const PackPair capped = approach + cap;
  const PackPairMask touching = capped > 0.0;
  const PackPair beyond = select(touching, capped, cap_approach);
  const PackPairMask loaded = beyond > cap_approach;
  // At the cap the elastic approach is known, and the same steps find its ninth root.
  const PackPair factor = only(loaded, race.film_factor * exponential(Film::kSpeed * log_speed));
  const LoadedFilm root = loaded_film(select(loaded, approach, beyond), factor, beyond);
  PackApproach e{select(touching, root.approach, capped), root.ninth, PackPair{}, PackPair{}};
  if constexpr (WithSlopes) {
    const PackPair film = select(loaded, root.film, cap);
    e.by_approach = 1.0 / (1.0 + only(loaded, m * film / root.approach));
    e.by_log_speed = e.by_approach *
                     select(loaded, spread<PackPair>(Film::kSpeed), spread<PackPair>(Film::kCapSpeed)) * film;
  }
  return e;
}

/// For any other film.
inline PackApproach any_film_approach(const RacePair& race, const PackPair& approach,
                                      const PackPair& log_speed) {
  const auto e = bearing::elastic_approach(race.film_law, race.log_stiffness, approach, log_speed);
  return {e.value, ninth_root(e.value), e.by_approach, e.by_log_speed};
}

/// By approach [m] and the logarithm of the entrainment speed [ln(m/s)].
template <bool WithSlopes>
PackApproach elastic_approach(const RacePair& race, const PackPair& approach, const PackPair& log_speed) {
  if (!race.film) return {approach, ninth_root(approach), spread<PackPair>(1.0), PackPair{}};
  if (race.film_law.has_powers()) return power_film_approach<WithSlopes>(race, approach, log_speed);
  return any_film_approach(race, approach, log_speed);
}

/// A load [N] and its slope by the elastic approach [N/m].
struct LoadSlope {
  PackPair load;
  PackPair slope;
};

/// Load of a straight roller.
inline LoadSlope straight_load(const RacePair& race, const PackApproach& e) {
  const PackPairMask touching = e.value > 0.0;
  const PackPair stiffness = only(touching, race.stiffness * e.ninth);
  return {stiffness * e.value, LineLaw::slope(stiffness)};
}

// Loads of contacts that are cut into laminae: motion/lamina_races.hpp, one roller a lane.

using namespace mechanics::ORBEARING_PACKS;

/// Sums over the laminae of both contacts of each roller, d being the approach of a lamina: of d^(10/9), of
/// d^(1/9), and of both times the position and its square.
struct LaminaPackSums {
  PackPair load{}, end_load{};
  PackPair by_approach{}, mixed{}, by_end_displacement{};
};

inline NumberPair drop_of(const LaminaConstants& laminae, int k) {
  return {laminae.inner_drop[k], laminae.outer_drop[k]};
}

/// No roller tilts: one half of the laminae represents both.
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

/// Additional approach of each contact at x = l/2 with the roller at `end_displacement`, the bore at
/// `outer_end_displacement`.
inline PackPair end_displacements(const Pack& end_displacement, const Pack& outer_end_displacement) {
  return {-end_displacement, end_displacement - outer_end_displacement};
}

/// Approaches and tilt of a pack of rollers: motion::RollerApproaches, and the rate of the end displacement
/// with its slopes.
struct RollerApproaches {
  Pack inner_approach{}, outer_approach{}, end_displacement{};  // [m]
  Pack rate{};                                                  // [m/s]  of the end displacement
  Pack by_end_displacement{}, by_inner{},
      by_outer{};  // [1/s]  its slopes, the latter by the rigid bodies' approaches
};

/// Load of each contact and its slope by its own elastic approach. The effect of the tilt through other
/// variables on the loads is left out of the slopes: the integrator keeps its order with any matrix, and the
/// tilt itself is solved for with all of its own (PackEngine::complete_rollers).
inline LoadSlope lamina_load(const RacePair& race, const PackApproach& e, const Pack& cosine,
                             const Pack& sine, RollerApproaches& approaches) {
  const LaminaConstants& laminae = race.laminae;
  approaches.inner_approach = e.value.low;
  approaches.outer_approach = e.value.high;
  const NumberPair share = race.stiffness * (1.0 / laminae.count);
  if (laminae.upright) {
    const LaminaPackSums sums = upright_sums(laminae, e.value);
    return {share * sums.load, LineLaw::slope(share) * sums.by_approach};
  }
  const Pack outer_end_displacement =
      laminae.bore_end_displacement_x * cosine + laminae.bore_end_displacement_y * sine;
  const LaminaPackSums sums =
      tilted_sums(laminae, e.value, end_displacements(approaches.end_displacement, outer_end_displacement));
  const NumberPair per_resistance = share * (1.0 / laminae.resistance);
  const PackPair moment = per_resistance * sums.end_load;
  const PackPair by_end_displacement = LineLaw::slope(per_resistance) * sums.by_end_displacement;
  const PackPair mixed = LineLaw::slope(per_resistance) * sums.mixed * e.by_approach;
  approaches.rate = moment.low - moment.high;
  approaches.by_end_displacement = -(by_end_displacement.low + by_end_displacement.high);
  approaches.by_inner = mixed.low;
  approaches.by_outer = -mixed.high;
  return {share * sums.load, LineLaw::slope(share) * sums.by_approach};
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
