// Elastic load of a race contact with its oil film, and its slopes: dynamics/race_load.hpp for packs of
// contacts.
#pragma once

#include "bearing/fast/constants.hpp"
#include "bearing/fast/lane_math.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// A value and its slopes by two arguments.
struct Slopes2 {
  Pack value;
  Pack by_first;
  Pack by_second;
};

/// x^(-13/90) to a few per cent, from the bits of `x` > 0, which are nearly its logarithm.
inline Pack rough_film_power(const Pack& x) {
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr long long kOne = 0x3ff0000000000000LL;
  const Pack exponent = detail::whole_numbers(bits_of(x) - bits(kOne), 32);
  return from_bits((detail::nearest(exponent * -m) << 32) + bits(kOne));
}

/// Binomial coefficients of a power.
struct BinomialSeries {
  double c[12];
  constexpr explicit BinomialSeries(double power) : c{1.0} {
    for (int k = 1; k < 12; ++k) c[k] = c[k - 1] * (power - (k - 1)) / k;
  }
};

/// (1 + x)^power for |x| < 0.1, relative error below 1e-12; pairs of terms first, which keeps all units busy.
inline Pack near_one_power(const Pack& x, const BinomialSeries& series) {
  const double(&c)[12] = series.c;
  const Pack x2 = x * x, x4 = x2 * x2;
  const Pack low = (c[0] + c[1] * x) + x2 * (c[2] + c[3] * x);
  const Pack middle = (c[4] + c[5] * x) + x2 * (c[6] + c[7] * x);
  const Pack high = (c[8] + c[9] * x) + x2 * (c[10] + c[11] * x);
  return low + x4 * (middle + x4 * high);
}

/// Root e of e - factor e^-m = approach, with film = factor e^-m and ninth = e^(1/9).
struct ThinnedFilm {
  Pack approach;
  Pack film;
  Pack ninth;
};

/// A start within a few per cent, one step of Halley, one of Newton; powers are followed by their series.
inline ThinnedFilm thinned_film(const Pack& approach, const Pack& factor, const Pack& beyond) {
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr BinomialSeries kFilmSeries(-m), kNinthSeries(1.0 / 9.0);
  Pack e = larger(approach + factor * rough_film_power(beyond), 0.1 * beyond);
  e = larger(approach + factor * rough_film_power(e), 0.5 * e);
  Pack film{}, ninth{}, ratio{};
  for (int i = 0; i < 4; ++i) {
    const Pack log_e = logarithm(e);
    const Pack inverse = 1.0 / e;
    film = factor * exponential(-m * log_e);
    ninth = exponential(log_e * (1.0 / 9.0));
    const Pack residual = e - film - approach;
    const Pack share = m * film * inverse;
    const Pack slope = 1.0 + share;
    const Pack step = residual * slope / (slope * slope + residual * (0.5 * (m + 1.0)) * share * inverse);
    ratio = -step * inverse;
    if (!any(absolute(ratio) > 0.1)) break;
    e = larger(e - step, 0.2 * e);  // a start far off: begin again from here
  }
  const Pack near = e * (1.0 + ratio);
  const Pack near_film = film * near_one_power(ratio, kFilmSeries);
  const Pack last = (near - near_film - approach) / (1.0 + m * near_film / near);
  const Pack small = -last / near;
  return {near - last, near_film * (1.0 - m * small),
          ninth * near_one_power(ratio, kNinthSeries) * (1.0 + small * (1.0 / 9.0))};
}

/// Elastic load [N] by approach [m] and entrainment speed [m/s], given with its logarithm; zero where there
/// is no contact.
template <bool WithSlopes>
Slopes2 elastic_load(const RaceConstants& race, const Pack& approach, const Pack& entrainment,
                     const Pack& log_entrainment) {
  const Pack tiny = spread(1e-30);
  if (!race.film) {
    const Pack e = larger(approach, tiny);
    const Pack stiffness = race.stiffness * exponential(logarithm(e) * (1.0 / 9.0));
    const Mask touching = approach > 0.0;
    return {only(touching, stiffness * e), only(touching, stiffness * (10.0 / 9.0)), Pack{}};
  }
  // Powers of the entrainment speed, dynamics/race_load.cpp: cap ~ u^(19/29), its approach ~ u^(9/29), factor
  // ~ u^0.7.
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr double kFilmSpeed = 0.7, kCapSpeed = 19.0 / 29.0;
  const Pack root29 = exponential(log_entrainment * (1.0 / 29.0));
  const Pack p2 = root29 * root29, p4 = p2 * p2, p8 = p4 * p4;
  const Pack cap = race.film_cap * (p8 * p8 * p2 * root29);
  const Pack cap_approach = race.film_cap_approach * (p8 * root29);
  const Pack beyond = larger(approach + cap, tiny);
  const Mask touching = approach + cap > 0.0;
  const Mask thinned = beyond > cap_approach;
  Pack e = beyond, film = cap, ninth{};
  if (any(thinned)) {
    const Pack factor = race.film_factor * exponential(kFilmSpeed * log_entrainment);
    const ThinnedFilm root = thinned_film(select(thinned, approach, cap_approach), factor,
                                          select(thinned, beyond, cap_approach + cap));
    e = select(thinned, root.approach, beyond);
    film = select(thinned, root.film, cap);
    ninth = root.ninth;
  }
  if (any(~thinned & touching)) ninth = select(thinned, ninth, exponential(logarithm(beyond) * (1.0 / 9.0)));
  const Pack stiffness = race.stiffness * ninth;
  Slopes2 result{only(touching, stiffness * e), Pack{}, Pack{}};
  if constexpr (WithSlopes) {
    const Pack yielding = only(thinned, m * film / e);
    result.by_first = only(touching, (10.0 / 9.0) * stiffness / (1.0 + yielding));
    result.by_second =
        result.by_first * select(thinned, spread(kFilmSpeed), spread(kCapSpeed)) * film / entrainment;
  }
  return result;
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
