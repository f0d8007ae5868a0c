// Guidance of the cage on the land of a ring: a short journal bearing with squeeze and whirl, and touch-down.
#pragma once

#include "bearing/contact/land_law.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

/// Land and oil, fixed for a run.
struct GuidanceModel {
  bool present = false;
  double side = 1.0;         // [-]      +1: the land is outside the cage, -1: inside
  double clearance = 0.0;    // [m]      radial
  double cage_radius = 0.0;  // [m]      of the cage's guided surface
  double land_width = 0.0;   // [m]      of one land
  int lands = 2;             // [-]
  double viscosity = 0.0;    // [Pa s]
  GuidanceFilm film = GuidanceFilm::short_bearing;
  double largest_eccentricity =
      0.98;                    // [-]      of the clearance: the film is held at this, and touch-down begins
  double stiffness = 0.0;      // [N/m]    of touch-down
  double damping = 0.0;        // [s/m]    of touch-down
  double friction = 0.0;       // [-]      of touch-down
  double sliding_scale = 0.0;  // [m/s]
};

/// Forces between cage and land.
struct GuidanceForces {
  Wrench on_cage;
  Wrench on_land;
  double eccentricity = 0.0;      // [-]  of the clearance
  double film_power = 0.0;        // [W]  dissipated, squeeze and shear
  double touch_down_power = 0.0;  // [W]  dissipated, damping and friction
};

/// The law of `model` with its constants; the model must have a land.
LandLaw land_law(const GuidanceModel& model);

/// Forces between the cage and the ring whose land guides it: the law of bearing/contact/land_law.hpp on both
/// bodies.
GuidanceForces guidance_forces(const GuidanceModel& model, const BodyMotion& cage, const BodyMotion& land);

/// Energy stored by touch-down [J].
double guidance_energy(const GuidanceModel& model, const Vector2& cage, const Vector2& land);

}  // namespace orbearing::bearing::motion
