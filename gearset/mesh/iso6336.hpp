// Mesh stiffness by the standard's regression: for comparison with the stiffness from tooth geometry.
#pragma once

#include <optional>

#include "gearset/parameters.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset {

/// Input of method B of ISO 6336-1 for a pair, in either order: the gear with fewer teeth is the pinion, of
/// two with as many that of the larger shift.
struct Iso6336Pair {
  int first_teeth = 0;
  int second_teeth = 0;       // 0: a ring, counted as infinitely many teeth
  double first_shift = 0.0;   // [module]
  double second_shift = 0.0;  // [module]  of a ring: positive inward, less that of PlanetarySet
  BasicRack rack;
  double contact_ratio = 0.0;  // [-]    transverse
  mechanics::Material material;
  double helix_angle = 0.0;  // [rad]  of either hand
  Web web{};
  std::optional<BasicRack> second_rack{};  // where it is not that of the first gear
};

/// C_R, by which the web of a gear that is not of one piece lowers the stiffness of its mesh; 1 without a
/// web. Eq. (19) of gearset/mesh/README.md [ISO6336].
double web_factor(const Web& web);

/// Stiffness per face width, of solid gears under more than 100 N per millimetre of face width.
struct Iso6336Stiffness {
  double theoretical_single = 0.0;  // [Pa]  c'_th, of one pair of teeth
  double single = 0.0;              // [Pa]  c'
  double mesh = 0.0;                // [Pa]  c_gamma_alpha, the mean over the mesh period
  bool in_range = true;  // the pinion's shift >= the wheel's, their sum from -0.5 to 2, helix up to 30 deg
};

/// Method B. Eqs. (9), (10) and (17) of gearset/mesh/README.md [ISO6336].
Iso6336Stiffness iso6336_stiffness(const Iso6336Pair& of_pair);

}  // namespace orbearing::gearset
