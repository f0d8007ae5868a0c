// Friction and rolling resistance of a race contact with their slopes: dynamics/traction.hpp for packs of
// contacts.
#pragma once

#include "bearing/fast/race_load.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// Friction on the roller [N] with slopes by load, sliding speed and entrainment speed.
struct Friction {
  Both force;
  Both by_load;
  Both by_sliding;
  Both by_entrainment;
};

inline Friction coulomb(const BothRaces& race, const Both& load, const Both& sliding) {
  const PerRace scale_square = race.sliding_scale * race.sliding_scale;
  const Both inverse = inverse_root(sliding * sliding + scale_square);
  const Both share = race.friction * sliding * inverse;
  return {load * share, share, load * (race.friction * scale_square) * (inverse * inverse * inverse), Both{}};
}

inline Friction limiting_shear(const BothRaces& race, const Both& load, const Both& sliding,
                               const Both& entrainment, const Both& log_entrainment) {
  const BothMask loaded = load > 0.0;
  const Both q = select(loaded, load, spread<Both>(1.0));
  const Both pressure = race.pressure_factor * root(q);
  const Both exponent = race.pressure_viscosity * pressure;
  const BothMask barus = exponent < spread(race.largest_exponent);
  const Both viscosity = race.viscosity * exponential(select(barus, exponent, spread(race.largest_exponent)));
  const BothMask thinned = q > spread(race.central_film_cap_load);
  const Both film = race.central_film_factor *
                    exponential(0.7 * log_entrainment -
                                0.13 * logarithm(select(thinned, q, spread(race.central_film_cap_load))));
  const Both sheared = race.friction * pressure * film / viscosity;
  const Both scale = sheared + race.sliding_scale;
  const Both size = absolute(sliding);
  const Both ratio = size / scale;
  const Both decay = exponential(-smaller(ratio, spread<Both>(600.0)));
  // 1 - exp(-x) loses digits for small x; there its series.
  const Both series =
      ratio *
      (1.0 -
       ratio * (0.5 - ratio * (1.0 / 6 -
                               ratio * (1.0 / 24 -
                                        ratio * (1.0 / 120 - ratio * (1.0 / 720 - ratio * (1.0 / 5040)))))));
  const Both rise = select(ratio < 1e-2, series, 1.0 - decay);
  const Both share = with_sign_of(race.friction * rise, sliding);
  const Both steep = race.friction * q * decay / scale;  // d(force)/d(sliding)
  const Both log_slope = 0.5 / q - only(thinned, 0.13 / q) - only(barus, 0.5 * exponent / q);
  const Both by_scale = -steep * sliding / scale;
  return {only(loaded, share * q), only(loaded, share + by_scale * sheared * log_slope), only(loaded, steep),
          only(loaded, by_scale * sheared * 0.7 / entrainment)};
}

/// Friction shared by film and asperities, dynamics/mixed_lubrication.hpp; `film` is that of the film alone.
inline Friction mixed_friction(const BothRaces& race, const Friction& film, const Both& load,
                               const Both& sliding, const Both& entrainment, const Both& log_entrainment) {
  constexpr double kLoad = 0.13, kSpeed = 0.7, kCapSpeed = 19.0 / 29.0;
  const BothMask loaded = load > 0.0;
  const Both q = select(loaded, load, spread<Both>(1.0));
  const Both free = race.least_film_factor * exponential(kSpeed * log_entrainment - kLoad * logarithm(q));
  const Both cap = race.least_film_cap * exponential(kCapSpeed * log_entrainment);
  const BothMask thinned = free < cap;
  const Both ratio = select(thinned, free, cap) * (1.0 / race.roughness);
  const Both inverse = 1.0 / (1.0 + ratio);
  const Both share = inverse * inverse;
  const Both by_log_film = -2.0 * share * ratio * inverse;  // d(share)/d(ln film)
  BothRaces boundary = race;
  boundary.friction = race.boundary_friction;
  boundary.sliding_scale = race.boundary_scale;
  const Friction dry = coulomb(boundary, load, sliding);
  const Both more = dry.force - film.force;
  const Both rest = 1.0 - share;
  return {
      share * dry.force + rest * film.force,
      share * dry.by_load + rest * film.by_load + only(thinned & loaded, more * by_log_film * (-kLoad) / q),
      share * dry.by_sliding + rest * film.by_sliding,
      rest * film.by_entrainment +
          more * by_log_film * select(thinned, spread<Both>(kSpeed), spread<Both>(kCapSpeed)) / entrainment};
}

/// Rolling resistance on each surface [N] with slopes by load and by the signed rolling speed; `turn` is the
/// rolling speed over the entrainment speed.
inline Slopes2 rolling_resistance(const BothRaces& race, const Both& load, const Both& rolling,
                                  const Both& log_entrainment, const Both& turn) {
  constexpr double a = 0.658, b = 0.0126, kLoadScale = 1.0;
  const BothMask loaded = load > 0.0;
  const Both q = select(loaded, load, spread<Both>(1.0));
  const Both powers = race.rolling_factor * exponential((a - 1.0) * log_entrainment + b * logarithm(q));
  const Both over = 1.0 / (q + kLoadScale);
  const Both share = powers * over;  // of the load
  const Both force = only(loaded, share * q * rolling);
  return {force, only(loaded, share * rolling * (b + kLoadScale * over)),
          only(loaded, share * q * (1.0 + (a - 1.0) * turn * turn))};
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
