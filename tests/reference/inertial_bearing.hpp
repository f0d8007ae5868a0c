// A second, different program of the planet bearing, as an engineer would write it from the equations without
// the first. An inertial frame with its origin on the carrier's axis, Cartesian coordinates, absolute speeds,
// so that no fictitious force can be left out or have a wrong sign; contact kinematics from the velocities of
// two points; films found by bisection, the land's film by quadrature. Slow and plain. It includes nothing of
// the library. Points and vectors of the plane are complex numbers.
#pragma once

#include <complex>
#include <vector>

namespace orbearing::reference {

using Plane = std::complex<double>;

struct Oil {
  double viscosity;           // [Pa s]
  double pressure_viscosity;  // [1/Pa]
};

/// One wave of the bending bore: its radius is larger by Re(conj(a) e^(i order phi)), phi the angle from the
/// carrier's arm.
struct RimWave {
  int order;
  double stiffness, mass, damping;  // [N/m], [kg], [N s/m]
  Plane at_rest;                    // [m]
};

struct BearingNumbers {
  double roller_radius, roller_length;                                               // [m]
  double pin_radius, bore_radius;                                                    // [m]   of the races
  double roller_mass, roller_inertia, cage_mass, cage_inertia, bore_mass, pin_mass;  // [kg], [kg m^2]
  double young, poisson;                                                             // [Pa], [-]
  Oil oil;
  bool film;                                          // takes part in the approach
  double damping;                                     // [s/m]
  double friction, sliding_scale, entrainment_scale;  // [-], [m/s], [m/s]
  double pocket_clearance, pocket_stiffness, pocket_damping, pocket_friction;
  double land_clearance, cage_guide_radius, land_width;  // [m]  radial; the land lies outside the cage
  int lands;
  double held_eccentricity;  // [-]  beyond it cage and land touch
  double land_stiffness, land_damping, land_friction;
  double support_stiffness, support_damping;  // [N/m], [N s/m]
  double mixture_density;                     // [kg/m^3]
  double cylinder_drag, churning;             // [-]
  double cage_mean_radius, cage_width;        // [m]
  std::vector<RimWave> rim = {};
  bool caged = true;                // else rollers meet their neighbours, the last the first
  double neighbour_friction = 0.0;  // [-]
  bool squeeze = false;             // oil is pressed out between rollers and races
  double roughness = 0.0;           // [m]  where asperities hold the film
  double gravity = 0.0;             // [m/s^2]  downward, against the second axis
};

/// The carrier turns about the origin; the undeformed axis of the pin is at orbit_radius on its arm.
struct Carrier {
  double angle, speed, acceleration;  // [rad], [rad/s], [rad/s^2]
  double orbit_radius;                // [m]
};

/// Seen from outside.
struct Body {
  Plane position, velocity;  // [m], [m/s]
  double angle = 0.0;        // [rad]
  double speed = 0.0;        // [rad/s]
};

struct Bodies {
  std::vector<Body> rollers;
  Body cage, bore, pin;              // the speeds of bore and pin are given
  std::vector<Plane> bent, bending;  // [m], [m/s]  amplitudes of the rim's waves and their rates
};

struct BodyAcceleration {
  Plane linear{};        // [m/s^2]
  double angular = 0.0;  // [rad/s^2]
};

struct Accelerations {
  std::vector<BodyAcceleration> rollers;
  BodyAcceleration cage, bore, pin;
  double bore_moment = 0.0, pin_moment = 0.0;  // [N m]  of the rollers, and of the cage on the bore's land
  std::vector<Plane> rim;                      // [m/s^2]  of the amplitudes
};

/// Accelerations by Newton and Euler under the contacts' forces and `bore_force` [N], which acts on the bore
/// from outside: in inertial directions, without terms of a rotating frame.
Accelerations accelerations(const BearingNumbers& bearing, const Carrier& carrier, const Bodies& bodies,
                            Plane bore_force);

}  // namespace orbearing::reference
