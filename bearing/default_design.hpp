// Default values for parts of a planet bearing that are not designed yet: they follow from the size and the
// material of the adjacent parts.
#pragma once

#include <string_view>

#include "bearing/pin_beam.hpp"

namespace orbearing::bearing {

/// Material of a cage of a given density.
struct CageMaterial {
  std::string_view name;
  double density = 0.0;         // [kg/m^3]
  double youngs_modulus = 0.0;  // [Pa]
  double damping = 0.0;         // [s/m]  share by which the load of a contact grows per speed of approach
};

/// The usual cage material nearest in density: glass-filled polyamide (warm), aluminium, steel or brass.
const CageMaterial& default_cage_material(double density);

/// The usual cage material of this name: polyamide, aluminium, steel or brass. Throws std::invalid_argument
/// for another one.
const CageMaterial& cage_material(std::string_view name);

/// Play of a roller in its pocket in diametral measure: a fiftieth of its diameter, at most half of the gap
/// between neighbours on the pitch circle. [m]; 0 where the rollers touch
double default_pocket_clearance(double roller_diameter, double pitch_diameter, int rollers);

/// Play of a cage on its land, in diametral measure. Assumption: 6 % of the diameter of a roller or ball. [m]
double default_land_play(double element_diameter);

/// Size of a cage that is not designed yet.
struct CageSize {
  double inner_diameter = 0.0;  // [m]
  double outer_diameter = 0.0;  // [m]
  double width = 0.0;           // [m]
};

/// As a window cage of sheet or polyamide has them: somewhat outside the pitch circle, since it is guided
/// there; `share_of_width` [-] of the bearing's, more where elements are longer.
CageSize default_cage_size(double pitch_diameter, double element_diameter, double element_length,
                           double bearing_width, double share_of_width = 0.76);

/// A bar between two pockets, held at both ends by the side rings of the cage.
struct CageBar {
  double length = 0.0;          // [m]  of the pocket
  double height = 0.0;          // [m]  radial
  double thickness = 0.0;       // [m]  along the pitch circle
  double youngs_modulus = 0.0;  // [Pa]
};

/// Thickness on the pitch circle that rollers with their play leave. [m]; not positive where there is no room
double cage_bar_thickness(double roller_diameter, double pocket_clearance, double pitch_diameter,
                          int rollers);

/// Load over mean deflection of a clamped beam with shear under a load spread over its length. [N/m]
/// delta/F = l^3/(720 E I) + 1.2 l/(12 G A)
double cage_bar_stiffness(const CageBar& bar);

/// Stiffness of a cage's land of that width on the ring. Assumption: a line contact, a fifth of modulus times
/// width. [N/m]
double default_touch_down_stiffness(double youngs_modulus, double width);

/// Pin of a planet, a solid round beam that carries its load spread over the length between the walls of the
/// carrier: it rests in the middles of both, or is clamped in one, half of span - length before the load. A
/// flexpin passes it at its free end, whose slope the sleeve keeps at zero.
struct PlanetPin {
  double diameter = 0.0;        // [m]
  double loaded_length = 0.0;   // [m]  b
  double span = 0.0;            // [m]  S, at least the loaded length
  double youngs_modulus = 0.0;  // [Pa]
  double poisson_ratio = 0.0;   // [-]
  PinEnds ends = PinEnds::both;
};

/// Load over mean deflection of the loaded length. [N/m]  With a = (S - b)/2, C = (2 S - b)/8:
/// delta/F = 2/(E I) (a^3/12 + C^2 b/2 - C b^2/24 + b^3/640) + kappa/(G A) (a/2 + b/12)   in both walls
/// delta/F = 1/(E I) (a^3/3 + a^2 b/2 + a b^2/4 + b^3/20) + kappa/(G A) (a + b/3)         clamped in one
/// delta/F = S^3/(12 E I) + kappa/(G A) S                                                 a flexpin
double pin_stiffness(const PlanetPin& pin);

}  // namespace orbearing::bearing
