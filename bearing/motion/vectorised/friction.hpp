// Friction and rolling resistance of a race contact with their slopes: dynamics/traction.hpp for packs of
// contacts.
#pragma once

#include "bearing/motion/vectorised/race_load.hpp"

namespace orbearing::bearing::fast::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Friction on the roller [N] with slopes by load, sliding speed and entrainment speed.
struct Friction {
  PackPair force;
  PackPair by_load;
  PackPair by_sliding;
  PackPair by_entrainment;
};

inline Friction coulomb(const BothRaces& race, const PackPair& load, const PackPair& sliding) {
  const NumberPair scale_square = race.sliding_scale * race.sliding_scale;
  const PackPair inverse = inverse_root(sliding * sliding + scale_square);
  const PackPair share = race.friction * sliding * inverse;
  return {load * share, share, load * (race.friction * scale_square) * (inverse * inverse * inverse),
          PackPair{}};
}

inline Friction limiting_shear(const BothRaces& race, const PackPair& load, const PackPair& sliding,
                               const PackPair& entrainment, const PackPair& log_entrainment) {
  const PackPairMask loaded = load > 0.0;
  const PackPair q = select(loaded, load, spread<PackPair>(1.0));
  const PackPair pressure = race.pressure_factor * root(q);
  const PackPair exponent = race.pressure_viscosity * pressure;
  const PackPairMask barus = exponent < spread(race.largest_exponent);
  const PackPair viscosity =
      race.viscosity * exponential(select(barus, exponent, spread(race.largest_exponent)));
  const PackPairMask thinned = q > spread(race.central_film_cap_load);
  const PackPair film = race.central_film_factor *
                        exponential(0.7 * log_entrainment -
                                    0.13 * logarithm(select(thinned, q, spread(race.central_film_cap_load))));
  const PackPair sheared = race.friction * pressure * film / viscosity;
  const PackPair scale = sheared + race.sliding_scale;
  const PackPair size = absolute(sliding);
  const PackPair ratio = size / scale;
  const PackPair decay = exponential(-smaller(ratio, spread<PackPair>(600.0)));
  // 1 - exp(-x) loses digits for small x; there its series.
  const PackPair series =
      ratio *
      (1.0 -
       ratio * (0.5 - ratio * (1.0 / 6 -
                               ratio * (1.0 / 24 -
                                        ratio * (1.0 / 120 - ratio * (1.0 / 720 - ratio * (1.0 / 5040)))))));
  const PackPair rise = select(ratio < 1e-2, series, 1.0 - decay);
  const PackPair share = with_sign_of(race.friction * rise, sliding);
  const PackPair steep = race.friction * q * decay / scale;  // d(force)/d(sliding)
  const PackPair log_slope = 0.5 / q - only(thinned, 0.13 / q) - only(barus, 0.5 * exponent / q);
  const PackPair by_scale = -steep * sliding / scale;
  return {only(loaded, share * q), only(loaded, share + by_scale * sheared * log_slope), only(loaded, steep),
          only(loaded, by_scale * sheared * 0.7 / entrainment)};
}

/// Friction shared by film and asperities, dynamics/mixed_lubrication.hpp; `film` is that of the film alone.
inline Friction mixed_friction(const BothRaces& race, const Friction& film, const PackPair& load,
                               const PackPair& sliding, const PackPair& entrainment,
                               const PackPair& log_entrainment) {
  constexpr double kLoad = 0.13, kSpeed = 0.7, kCapSpeed = 19.0 / 29.0;
  const PackPairMask loaded = load > 0.0;
  const PackPair q = select(loaded, load, spread<PackPair>(1.0));
  const PackPair free = race.least_film_factor * exponential(kSpeed * log_entrainment - kLoad * logarithm(q));
  const PackPair cap = race.least_film_cap * exponential(kCapSpeed * log_entrainment);
  const PackPairMask thinned = free < cap;
  const PackPair ratio = select(thinned, free, cap) * (1.0 / race.roughness);
  const PackPair inverse = 1.0 / (1.0 + ratio);
  const PackPair share = inverse * inverse;
  const PackPair by_log_film = -2.0 * share * ratio * inverse;  // d(share)/d(ln film)
  BothRaces boundary = race;
  boundary.friction = race.boundary_friction;
  boundary.sliding_scale = race.boundary_scale;
  const Friction dry = coulomb(boundary, load, sliding);
  const PackPair more = dry.force - film.force;
  const PackPair rest = 1.0 - share;
  return {
      share * dry.force + rest * film.force,
      share * dry.by_load + rest * film.by_load + only(thinned & loaded, more * by_log_film * (-kLoad) / q),
      share * dry.by_sliding + rest * film.by_sliding,
      rest * film.by_entrainment +
          more * by_log_film * select(thinned, spread<PackPair>(kSpeed), spread<PackPair>(kCapSpeed)) /
              entrainment};
}

/// Rolling resistance on each surface [N] with slopes by load and by the signed rolling speed; `turn` is the
/// rolling speed over the entrainment speed.
inline Slopes2 rolling_resistance(const BothRaces& race, const PackPair& load, const PackPair& rolling,
                                  const PackPair& log_entrainment, const PackPair& turn) {
  constexpr double a = 0.658, b = 0.0126, kLoadScale = 1.0;
  const PackPairMask loaded = load > 0.0;
  const PackPair q = select(loaded, load, spread<PackPair>(1.0));
  const PackPair powers = race.rolling_factor * exponential((a - 1.0) * log_entrainment + b * logarithm(q));
  const PackPair over = 1.0 / (q + kLoadScale);
  const PackPair share = powers * over;  // of the load
  const PackPair force = only(loaded, share * q * rolling);
  return {force, only(loaded, share * rolling * (b + kLoadScale * over)),
          only(loaded, share * q * (1.0 + (a - 1.0) * turn * turn))};
}

}  // namespace orbearing::bearing::fast::ORBEARING_PACKS
