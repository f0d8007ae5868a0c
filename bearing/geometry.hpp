// What follows from the bearing's parameters once and for all: radii, masses, inertias.
#pragma once

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Derived geometry and inertia of a cylindrical roller bearing.
struct RollerBearingGeometry {
  double pitch_radius = 0.0;     // [m]
  double roller_radius = 0.0;    // [m]
  double inner_radius = 0.0;     // [m]       race of the pin: R_i
  double outer_radius = 0.0;     // [m]       race of the bore: R_o
  double roller_mass = 0.0;      // [kg]
  double roller_inertia = 0.0;   // [kg m^2]  about its own axis
  double cage_mass = 0.0;        // [kg]      ring less pockets
  double cage_inertia = 0.0;     // [kg m^2]  about its axis
  double outer_ring_mass = 0.0;  // [kg]      between outer race and outside diameter
  double inner_ring_mass = 0.0;  // [kg]      between bore and inner race
};

/// Geometry of `bearing`. The clearance is shared evenly: races of diameter d_m -+ (D + G/2).
RollerBearingGeometry geometry_of(const CylindricalRollerBearing& bearing);

/// Equivalent radius of a roller on its race [m]: convex on the inner race, concave on the outer.
double equivalent_radius(const RollerBearingGeometry& geometry, Race race);

/// Speed of the cage at pure rolling [rad/s], from the speeds of both races in the same frame.
double kinematic_cage_speed(const RollerBearingGeometry& geometry, double inner_speed, double outer_speed);

/// Spin of a roller at pure rolling on both races [rad/s], in the frame of the race speeds.
double kinematic_roller_spin(const RollerBearingGeometry& geometry, double inner_speed, double outer_speed);

}  // namespace orbearing::bearing
