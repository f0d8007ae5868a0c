// What the user states about the bodies, springs and meshes of a planetary set, and what drives it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "gearset/kinematics.hpp"
#include "gearset/mesh/periodic_curve.hpp"
#include "gearset/parameters.hpp"

namespace orbearing::gearset::dynamics {

/// How the housing holds a central member. Rotations count as u = radius x angle.
struct Support {
  double stiffness = 0.0;            // [N/m]    x and y; 0: floating
  double damping = 0.0;              // [N s/m]  x and y
  double torsional_stiffness = 0.0;  // [N/m]    on u; 0: free to turn
  double torsional_damping = 0.0;    // [N s/m]  on u
  bool held_in_place = false;        // x and y are zero, whatever the force
  bool held_in_rotation = false;     // u is zero
};

/// Sun, ring or carrier.
struct CentralMember {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg]  moment of inertia / radius^2
  double radius = 0.0;   // [m]   base radius of sun and ring, centre distance for the carrier
  Support support;
};

/// Bearings of a planet that need not be alike in all directions. With the displacement d [m] of the planet's
/// axis from its pin's, outward and in the sense of rotation, they exert on the planet
///   force - stiffness d - damping d'.
struct AffineBearing {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();      // [N]      at no displacement
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]
  Eigen::Matrix2d damping = Eigen::Matrix2d::Zero();    // [N s/m]
};

/// All planets are alike.
struct PlanetMember {
  double mass = 0.0;               // [kg]
  double inertia = 0.0;            // [kg]     moment of inertia / radius^2
  double radius = 0.0;             // [m]      base radius
  double bearing_stiffness = 0.0;  // [N/m]    planet to carrier, radial and tangential; all its bearings
  double bearing_damping = 0.0;    // [N s/m]  the same
  bool coupled_bearing = false;    // forces come through a port; the two above are not used
  std::optional<AffineBearing> affine_bearing;  // in place of the stiffness and damping above
};

/// Sun or ring mesh, alike for all planets but for its phase.
struct Mesh {
  double pressure_angle = 0.0;  // [rad]    working
  PeriodicCurve stiffness;      // [N/m]    along the line of action, over a mesh period
  PeriodicCurve error;    // [m]      transmission error of unloaded teeth: positive where material lacks
  double damping = 0.0;   // [N s/m]  while in contact
  double backlash = 0.0;  // [m]      between both flanks, along the line of action
};

/// Terms of the carrier's rotation that act on the bodies.
struct FrameSwitches {
  bool coriolis = true;
  bool centrifugal = true;
  bool euler = true;
};

/// One planetary set. Planet n stands at the angle 2 pi n / planets.
struct SetParameters {
  int planets = 0;
  CentralMember sun;
  CentralMember ring;
  CentralMember carrier;
  PlanetMember planet;
  Mesh sun_mesh;
  Mesh ring_mesh;
  std::vector<double> sun_phase;   // [mesh period]  (planets)  added to the common place in the period
  std::vector<double> ring_phase;  // [mesh period]  (planets)
  Eigen::Matrix2Xd pin_error;  // [m]  (radial and tangential, planets)  of the pin in the carrier; or empty
  FrameSwitches frame;
  bool separation = true;  // teeth push only, beyond half the backlash; false: they also pull
};

/// Speed of all members over time: the factor on the nominal speeds goes from `from` to 1 at a constant rate.
struct RunUp {
  double from = 1.0;      // [-]  greater than 0
  double duration = 0.0;  // [s]  0: the nominal speed from the start
};

/// Speeds and torques at which the set runs.
struct Operation {
  Member driven = Member::sun;
  double power = 0.0;           // [W]   enters by the driven member, whatever its speed
  Speeds speeds;                // [rad/s]  nominal
  Torques torques;              // [N m]    external, in balance at nominal speed
  double mesh_frequency = 0.0;  // [Hz]  at nominal speed
  RunUp run_up;
  /// What the moments of coupled bearings take from the rotation of the set, the load does not get: the set
  /// keeps its mean speed. False: the load's torque stays, and friction slows the set down.
  bool load_yields = true;
};

/// Operation of a set whose tooth numbers are known.
/// @throws std::invalid_argument as member_speeds and member_torques
Operation operation_of(const PlanetarySet& set, const Drive& drive);

}  // namespace orbearing::gearset::dynamics
