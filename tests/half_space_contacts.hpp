// A roller on its inner race for the tests of the half-space contact: the reducer's, 5.24 x 5.7 mm.
#pragma once

#include <cmath>

#include "bearing/pressure/strip_contact.hpp"
#include "mechanics/constants.hpp"
#include "tests/reference/surface_contact.hpp"

namespace orbearing::bearing::half_space {

inline constexpr double kRollerDiameter = 5.24e-3;  // [m]
inline constexpr double kRollerLoad = 1500.0;       // [N]  Hertzian pressure 2.06 GPa, half width 81 um

inline HalfSpaceContact reducer_roller(EndSurface roller_ends = EndSurface::corrected) {
  const double roller = 0.5 * kRollerDiameter, race = 15.2e-3;
  return {
      .length = 5.7e-3, .equivalent_radius = 1.0 / (1.0 / roller + 1.0 / race), .roller_ends = roller_ends};
}

/// Exponent lambda [-] with which pressure grows as r^-lambda towards the end of a straight contact with
/// sharp corners in this model: cos(pi lambda) = mirror factor; 1/2 for half-spaces. Zero from factor 1 on,
/// where pressure stays finite. (A true quarter space on a half-space of the same material: 0.226,
/// [DundursLee1972].)
inline double corner_exponent(double mirror_factor) {
  return mirror_factor < 1.0 ? std::acos(mirror_factor) / constants::pi : 0.0;
}

inline Relief straight() {
  return [](double) { return 0.0; };
}

inline Relief reference_profile() {
  return relief_of(profile::Iso16281{.length = 5.7e-3, .diameter = kRollerDiameter});
}

}  // namespace orbearing::bearing::half_space
