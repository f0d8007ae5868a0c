// The constants of both races side by side, as the laws of race_contact read them: inner low, outer high.
#pragma once

#include "bearing/motion/vectorised/constants.hpp"
#include "mechanics/packs/pack.hpp"

namespace orbearing::bearing::fast::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

struct BothRaces : RaceNumbers<NumberPair> {
  bool round = true;  // neither race has waves
  const RaceConstants* inner = nullptr;
  const RaceConstants* outer = nullptr;
  LaminaConstants laminae;
};

/// Both races follow the same laws, with numbers of their own. Keeps pointers to `inner`, `outer` and what
/// `laminae` points to.
inline BothRaces both_races(const RaceConstants& inner, const RaceConstants& outer,
                            const LaminaConstants& laminae) {
  BothRaces both;
  const auto join = [&](NumberPair RaceNumbers<NumberPair>::*into, double RaceNumbers<double>::*from) {
    both.*into = {inner.*from, outer.*from};
  };
  using To = RaceNumbers<NumberPair>;
  using From = RaceNumbers<double>;
  join(&To::side, &From::side);
  join(&To::radius, &From::radius);
  join(&To::speed, &From::speed);
  join(&To::stiffness, &From::stiffness);
  join(&To::damping, &From::damping);
  join(&To::entrainment_scale, &From::entrainment_scale);
  join(&To::film_factor, &From::film_factor);
  join(&To::film_cap, &From::film_cap);
  join(&To::film_cap_approach, &From::film_cap_approach);
  join(&To::friction, &From::friction);
  join(&To::sliding_scale, &From::sliding_scale);
  join(&To::largest_exponent, &From::largest_exponent);
  join(&To::pressure_factor, &From::pressure_factor);
  join(&To::pressure_viscosity, &From::pressure_viscosity);
  join(&To::viscosity, &From::viscosity);
  join(&To::central_film_factor, &From::central_film_factor);
  join(&To::central_film_cap_load, &From::central_film_cap_load);
  join(&To::roughness, &From::roughness);
  join(&To::boundary_friction, &From::boundary_friction);
  join(&To::boundary_scale, &From::boundary_scale);
  join(&To::least_film_factor, &From::least_film_factor);
  join(&To::least_film_cap, &From::least_film_cap);
  join(&To::rolling_factor, &From::rolling_factor);
  both.film = inner.film;
  both.limiting_shear = inner.limiting_shear;
  both.mixed = inner.mixed;
  both.rolling_resistance = inner.rolling_resistance;
  both.round = inner.waves == 0 && outer.waves == 0;
  both.inner = &inner;
  both.outer = &outer;
  both.laminae = laminae;
  return both;
}

}  // namespace orbearing::bearing::fast::ORBEARING_PACKS
