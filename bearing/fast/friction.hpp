// Friction and rolling resistance of a race contact with their slopes: dynamics/traction.hpp for packs of
// contacts.
#pragma once

#include "bearing/fast/race_load.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// Friction on the roller [N] with slopes by load, sliding speed and entrainment speed.
struct Friction {
  Pack force;
  Pack by_load{};
  Pack by_sliding{};
  Pack by_entrainment{};
};

inline Friction coulomb(const RaceConstants& race, const Pack& load, const Pack& sliding) {
  const double scale_square = race.sliding_scale * race.sliding_scale;
  const Pack inverse = 1.0 / root(sliding * sliding + scale_square);
  const Pack share = race.friction * sliding * inverse;
  return {load * share, share, load * (race.friction * scale_square) * (inverse * inverse * inverse), Pack{}};
}

inline Friction limiting_shear(const RaceConstants& race, const Pack& load, const Pack& sliding,
                               const Pack& entrainment, const Pack& log_entrainment) {
  const Mask loaded = load > 0.0;
  const Pack q = select(loaded, load, spread(1.0));
  const Pack pressure = race.pressure_factor * root(q);
  const Pack exponent = race.pressure_viscosity * pressure;
  const Mask barus = exponent < race.largest_exponent;
  const Pack viscosity = race.viscosity * exponential(select(barus, exponent, spread(race.largest_exponent)));
  const Mask thinned = q > race.central_film_cap_load;
  const Pack film = race.central_film_factor *
                    exponential(0.7 * log_entrainment -
                                0.13 * logarithm(select(thinned, q, spread(race.central_film_cap_load))));
  const Pack sheared = race.friction * pressure * film / viscosity;
  const Pack scale = sheared + race.sliding_scale;
  const Pack size = absolute(sliding);
  const Pack ratio = size / scale;
  const Pack decay = exponential(-smaller(ratio, spread(600.0)));
  // 1 - exp(-x) loses digits for small x; there its series.
  const Pack series =
      ratio *
      (1.0 -
       ratio * (0.5 - ratio * (1.0 / 6 -
                               ratio * (1.0 / 24 -
                                        ratio * (1.0 / 120 - ratio * (1.0 / 720 - ratio * (1.0 / 5040)))))));
  const Pack rise = select(ratio < 1e-2, series, 1.0 - decay);
  const Pack share = with_sign_of(race.friction * rise, sliding);
  const Pack steep = race.friction * q * decay / scale;  // d(force)/d(sliding)
  const Pack log_slope = 0.5 / q - only(thinned, 0.13 / q) - only(barus, 0.5 * exponent / q);
  const Pack by_scale = -steep * sliding / scale;
  return {only(loaded, share * q), only(loaded, share + by_scale * sheared * log_slope), only(loaded, steep),
          only(loaded, by_scale * sheared * 0.7 / entrainment)};
}

/// Friction shared by film and asperities, dynamics/mixed_lubrication.hpp; `film` is that of the film alone.
inline Friction mixed_friction(const RaceConstants& race, const Friction& film, const Pack& load,
                               const Pack& sliding, const Pack& entrainment, const Pack& log_entrainment) {
  constexpr double kLoad = 0.13, kSpeed = 0.7, kCapSpeed = 19.0 / 29.0;
  const Mask loaded = load > 0.0;
  const Pack q = select(loaded, load, spread(1.0));
  const Pack free = race.least_film_factor * exponential(kSpeed * log_entrainment - kLoad * logarithm(q));
  const Pack cap = race.least_film_cap * exponential(kCapSpeed * log_entrainment);
  const Mask thinned = free < cap;
  const Pack ratio = select(thinned, free, cap) * (1.0 / race.roughness);
  const Pack inverse = 1.0 / (1.0 + ratio);
  const Pack share = inverse * inverse;
  const Pack by_log_film = -2.0 * share * ratio * inverse;  // d(share)/d(ln film)
  RaceConstants boundary = race;
  boundary.friction = race.boundary_friction;
  boundary.sliding_scale = race.boundary_scale;
  const Friction dry = coulomb(boundary, load, sliding);
  const Pack more = dry.force - film.force;
  const Pack rest = 1.0 - share;
  return {
      share * dry.force + rest * film.force,
      share * dry.by_load + rest * film.by_load + only(thinned & loaded, more * by_log_film * (-kLoad) / q),
      share * dry.by_sliding + rest * film.by_sliding,
      rest * film.by_entrainment +
          more * by_log_film * select(thinned, spread(kSpeed), spread(kCapSpeed)) / entrainment};
}

/// Rolling resistance on each surface [N] with slopes by load and by the signed rolling speed; `turn` is the
/// rolling speed over the entrainment speed.
inline Slopes2 rolling_resistance(const RaceConstants& race, const Pack& load, const Pack& rolling,
                                  const Pack& log_entrainment, const Pack& turn) {
  constexpr double a = 0.658, b = 0.0126, kLoadScale = 1.0;
  const Mask loaded = load > 0.0;
  const Pack q = select(loaded, load, spread(1.0));
  const Pack powers = race.rolling_factor * exponential((a - 1.0) * log_entrainment + b * logarithm(q));
  const Pack over = 1.0 / (q + kLoadScale);
  const Pack share = powers * over;  // of the load
  const Pack force = only(loaded, share * q * rolling);
  return {force, only(loaded, share * rolling * (b + kLoadScale * over)),
          only(loaded, share * q * (1.0 + (a - 1.0) * turn * turn))};
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
