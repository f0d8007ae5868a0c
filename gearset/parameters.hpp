// What the user states about a planetary gear set, and how it is driven. SI units throughout.
#pragma once

namespace orbearing::gearset {

/// The three coaxial members of a simple planetary gear set.
enum class Member { sun, ring, carrier };

/// Basic rack profile; lengths in units of the module (ISO 53).
struct BasicRack {
  double pressure_angle = 0.3490658503988659;  // [rad]     20 degrees
  double addendum = 1.0;                       // [module]  of the gear: h_a*
  double clearance = 0.25;                     // [module]  bottom clearance: c*
  double root_fillet_radius = 0.38;            // [module]  rho_f*
};

/// Parameters of one planetary set with equally spaced planets.
struct PlanetarySet {
  int sun_teeth = 0;
  int planet_teeth = 0;
  int ring_teeth = 0;
  int planets = 0;
  double module = 0.0;  // [m]
  BasicRack rack;
  double sun_shift = 0.0;  // [module]  profile shift; the planet's follows from the common centre distance
  double ring_shift =
      0.0;  // [module]  positive outward, as of the external gear that fills the ring's spaces
  double face_width = 0.0;   // [m]
  double planet_bore = 0.0;  // [m]       diameter of the hole that the planet's bearings fill
  double density = 7850.0;   // [kg/m^3]
  Member fixed_member = Member::ring;
};

/// The power that enters the set, and where. The member that is neither fixed nor driven delivers.
struct Drive {
  Member member = Member::sun;
  double power = 0.0;  // [W]
  double speed = 0.0;  // [rad/s]  of the driven member, relative to the housing
};

}  // namespace orbearing::gearset
