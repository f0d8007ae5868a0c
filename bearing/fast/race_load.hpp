// Elastic load of a race contact with its oil film, and its slopes: dynamics/race_load.hpp for packs of
// contacts.
#pragma once

#include "bearing/fast/both_races.hpp"
#include "bearing/fast/lane_powers.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// A value and its slopes by two arguments.
struct Slopes2 {
  Both value;
  Both by_first;
  Both by_second;
};

/// Root e of e - factor e^(-13/90) = approach, with film = factor e^(-13/90) and ninth = e^(1/9).
struct ThinnedFilm {
  Both approach;
  Both film;
  Both ninth;
};

/// The powers of x that thinned_film() needs, by multiplication.
struct NinetiethPowers {
  Both tenth;       // x^10
  Both thirteenth;  // x^13
  Both ninetieth;   // x^90

  explicit NinetiethPowers(const Both& x) {
    const Both x2 = x * x, x4 = x2 * x2;
    tenth = (x4 * x) * (x4 * x);
    thirteenth = tenth * (x2 * x);
    const Both x20 = tenth * tenth, x40 = x20 * x20;
    ninetieth = (x40 * x40) * tenth;
  }
};

/// x with x^90 = e for 1e-12 < e < 1, to a few per cent of e.
inline Both rough_ninetieth_root(const Both& e) {
  constexpr double kLog2 = 0.6931471805599453 / 90.0, kMiddle = -0.16, kRoot = 0.85214378896621133;
  const Both t = (rough_log2(e) + 0.043) * kLog2 - kMiddle;
  return kRoot * (1.0 + t * (1.0 + t * (0.5 + t * (1.0 / 6))));
}

/// With e = x^90 all powers are whole ones: x^90 - factor x^-13 = approach. A start within some per cent,
/// then steps of Halley in x; `beyond` is a bound of e from above.
inline ThinnedFilm thinned_film(const Both& approach, const Both& factor, const Both& beyond) {
  constexpr double m = 13.0 / 90.0, kRough = 0.97;  // of a rough power, which is never too small
  constexpr double kLargest = 0.02, kNear = 2e-6;   // of steps; after the latter round-off is left
  Both e = larger(approach + factor * (kRough * rough_power(beyond, -m)), 0.1 * beyond);
  e = larger(approach + factor * (kRough * rough_power(e, -m)), 0.5 * e);
  Both x = rough_ninetieth_root(e);
  for (int i = 0; i < 6; ++i) {
    const NinetiethPowers powers(x);
    // f = e - film - approach, x f' and x^2 f'' / 2, all times x^13.
    const Both squeezed = powers.ninetieth * powers.thirteenth;
    const Both value = squeezed - factor - approach * powers.thirteenth;
    const Both slope = 90.0 * squeezed + 13.0 * factor;
    const Both half_bend = 4005.0 * squeezed - 91.0 * factor;
    const Both step = value * slope / (slope * slope - value * half_bend);
    x = x * (1.0 - smaller(larger(step, spread<Both>(-kLargest)), spread<Both>(kLargest)));
    if (i > 0 && !any(absolute(step) > kNear)) break;
  }
  const NinetiethPowers powers(x);
  return {powers.ninetieth, powers.ninetieth - approach, powers.tenth};
}

/// Elastic approach of a contact in the middle and its slopes.
struct ElasticApproach {
  Both value;           // [m]  zero or negative without contact
  Both ninth;           // [m^(1/9)]  its ninth root, where it is positive
  Both by_approach;     // [-]
  Both by_entrainment;  // [s]
};

/// By approach [m] and entrainment speed [m/s], given with its logarithm: dynamics/race_load.cpp.
template <bool WithSlopes>
ElasticApproach elastic_approach(const BothRaces& race, const Both& approach, const Both& entrainment,
                                 const Both& log_entrainment) {
  if (!race.film) return {approach, ninth_root(approach), spread<Both>(1.0), Both{}};
  // Powers of the entrainment speed: cap ~ u^(19/29), its approach ~ u^(9/29), factor ~ u^0.7.
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr double kFilmSpeed = 0.7, kCapSpeed = 19.0 / 29.0;
  const Both root29 = exponential(log_entrainment * (1.0 / 29.0));
  const Both p2 = root29 * root29, p4 = p2 * p2, p8 = p4 * p4;
  const Both cap = race.film_cap * (p8 * p8 * p2 * root29);
  const Both cap_approach = race.film_cap_approach * (p8 * root29);
  const Both capped = approach + cap;
  const BothMask touching = capped > 0.0;
  const Both beyond = select(touching, capped, cap_approach);
  const BothMask thinned = beyond > cap_approach;
  // At the cap the elastic approach is known, and the same steps find its ninth root.
  const Both factor = only(thinned, race.film_factor * exponential(kFilmSpeed * log_entrainment));
  const ThinnedFilm root = thinned_film(select(thinned, approach, beyond), factor, beyond);
  ElasticApproach e{select(touching, root.approach, capped), root.ninth, Both{}, Both{}};
  if constexpr (WithSlopes) {
    const Both film = select(thinned, root.film, cap);
    e.by_approach = 1.0 / (1.0 + only(thinned, m * film / root.approach));
    e.by_entrainment = e.by_approach * select(thinned, spread<Both>(kFilmSpeed), spread<Both>(kCapSpeed)) *
                       film / entrainment;
  }
  return e;
}

/// A load [N] and its slope by the elastic approach [N/m].
struct LoadSlope {
  Both load;
  Both slope;
};

/// Of a straight roller.
inline LoadSlope straight_load(const BothRaces& race, const ElasticApproach& e) {
  const BothMask touching = e.value > 0.0;
  const Both stiffness = only(touching, race.stiffness * e.ninth);
  return {stiffness * e.value, (10.0 / 9.0) * stiffness};
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
