// Values derived once from the bearing's parameters: radii, masses, inertias.
#pragma once

#include "bearing/parameters.hpp"
#include "bearing/profile/profile.hpp"
#include "bearing/profile/stated_profile.hpp"

namespace orbearing::bearing {

/// Derived geometry and inertia of a bearing.
struct BearingGeometry {
  double pitch_radius = 0.0;     // [m]
  double element_radius = 0.0;   // [m]       of a roller or ball
  double slenderness = 0.0;      // [-]       gamma = D cos(alpha)/d_m
  double inner_radius = 0.0;     // [m]       of the inner race, of a groove where it is deepest: R_i
  double outer_radius = 0.0;     // [m]       of the outer race: R_o
  double element_mass = 0.0;     // [kg]
  double element_inertia = 0.0;  // [kg m^2]  about its own axis
  double cage_mass = 0.0;        // [kg]      ring less pockets
  double cage_inertia = 0.0;     // [kg m^2]  about its axis
  double outer_ring_mass = 0.0;  // [kg]      between race and outside diameter; no grooves taken off
  double inner_ring_mass = 0.0;  // [kg]      between bore and race; without a ring, of the pin
};

/// Geometry of `bearing`. The clearance is shared evenly: races of diameter d_m -+ (D + G/2).
BearingGeometry geometry_of(const Bearing& bearing);

/// Whether an outer ring lies between race and seat: else rollers run in the planet's bore, and the ring's
/// mass is what round-off leaves.
bool has_outer_ring(const Bearing& bearing, const BearingGeometry& geometry);

/// Equivalent radius of a roller on its race [m]: convex on the inner race, concave on the outer.
double equivalent_radius(const BearingGeometry& geometry, Race race);

/// Design load of a logarithmic profile of the rollers: `load` [N] on the inner race, which has the highest
/// pressure.
profile::DesignLoad design_under(const Bearing& bearing, double load);

/// Gives the rollers the profile that is stated; they keep theirs where none is. Throws std::invalid_argument
/// for a profile without a meaning.
void put_profile(const profile::StatedProfile& stated, Bearing& bearing);

/// Speed of the cage at pure rolling [rad/s], from the speeds of both races in the same frame; `slenderness`
/// as above.
double kinematic_cage_speed(double slenderness, double inner_speed, double outer_speed);
double kinematic_cage_speed(const BearingGeometry& geometry, double inner_speed, double outer_speed);

/// Spin of a roller at pure rolling on both races [rad/s], in the frame of the race speeds.
double kinematic_roller_spin(const BearingGeometry& geometry, double inner_speed, double outer_speed);

}  // namespace orbearing::bearing
