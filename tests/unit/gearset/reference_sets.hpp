// Planetary sets that several tests share.
#pragma once

#include <vector>

#include "gearset/parameters.hpp"

namespace orbearing::gearset {

/// The three sets of [Gai2025], Table 1. Its row of shifts is damaged; the ring's shifts are read as
/// positive, and the sign of the sun's is open.
/// @param sun_sign +1 or -1
inline std::vector<PlanetarySet> gai_sets(double sun_sign) {
  PlanetarySet reduction{37, 22, 79, 4, 3e-3, {}, sun_sign * 0.2618, 0.4146, 28e-3, 47e-3};
  PlanetarySet coupling{30, 19, 66, 4, 4e-3, {}, sun_sign * 0.2337, 0.5361, 32e-3, 52e-3};
  PlanetarySet transmission{23, 18, 57, 4, 4e-3, {}, sun_sign * 0.3058, 0.8425, 40e-3, 0.0};
  return {reduction, coupling, transmission};
}

inline PlanetarySet reducer() {
  return gai_sets(1.0).front();
}

/// Unshifted set whose ring has exactly sun + 2 planet teeth.
inline PlanetarySet standard_set() {
  return {30, 30, 90, 4, 2e-3, {}, 0.0, 0.0, 20e-3, 30e-3};
}

/// The set with helical teeth. [rad]
inline PlanetarySet with_helix(PlanetarySet set, double helix_angle) {
  set.helix_angle = helix_angle;
  return set;
}

/// Low-speed stage of a wind turbine of 750 kW, 7.5 deg: numbers of [Oyague2011]; shifts of sun and planet by
/// their root diameters of 186 and 372 mm, that of the ring by the centre distance of 308 mm.
inline PlanetarySet wind_stage() {
  PlanetarySet set{21, 39, 99, 3, 10e-3, {}, 0.1763, 0.9737, 220e-3, 290e-3};
  set.helix_angle = 7.5 * 0.017453292519943295;
  return set;
}

inline std::vector<PlanetarySet> all_sets() {
  std::vector<PlanetarySet> sets = gai_sets(1.0);
  for (const PlanetarySet& set : gai_sets(-1.0)) sets.push_back(set);
  sets.push_back(standard_set());
  return sets;
}

}  // namespace orbearing::gearset
