// A roller on its inner race for the tests of the half-space contact: the reducer's, 5.24 x 5.7 mm.
#pragma once

#include "bearing/pressure/of_bearing.hpp"
#include "bearing/pressure/strip_contact.hpp"
#include "tests/reference/surface_contact.hpp"

namespace orbearing::bearing::half_space {

inline constexpr double kRollerDiameter = 5.24e-3;  // [m]
inline constexpr double kRollerLoad = 1500.0;       // [N]  Hertzian pressure 2.06 GPa, half width 81 um

inline HalfSpaceContact reducer_roller(EndSurface roller_ends = EndSurface::corrected) {
  const double roller = 0.5 * kRollerDiameter, race = 15.2e-3;
  return {
      .length = 5.7e-3, .equivalent_radius = 1.0 / (1.0 / roller + 1.0 / race), .roller_ends = roller_ends};
}

inline Relief straight() {
  return [](double) { return 0.0; };
}

inline Relief reference_profile() {
  return relief_of(profile::Iso16281{.length = 5.7e-3, .diameter = kRollerDiameter});
}

}  // namespace orbearing::bearing::half_space
