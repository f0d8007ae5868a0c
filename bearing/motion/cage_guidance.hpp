// Guidance of the cage on the land of a ring: a short journal bearing with squeeze and whirl, and touch-down.
#pragma once

#include "bearing/motion/parameters.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::dynamics {

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

/// Resistance of the half film to the squeeze velocity v': force = -film_coefficient * resistance * v', with
/// the integral of u u^T / (1 - eps cos)^3 over the half circle towards v' in axes (along the eccentricity,
/// across it).
struct FilmResistance {
  double along = 0.0;   // [-]
  double mixed = 0.0;   // [-]
  double across = 0.0;  // [-]
};

/// Resistance at `eccentricity` [-] < 1 against a squeeze velocity along `direction` (any length), given in
/// axes along the eccentricity and across it; none where its length is zero. Closed form by the substitution
/// of [Sommerfeld1904] in the short bearing of [Ocvirk1952]; its steady state is Eqs. (24) and (25) of
/// [Gai2025].
FilmResistance half_film_resistance(double eccentricity, const Vector2& direction);

/// Film force [N] on the cage as Eqs. (24) and (25) of [Gai2025] print it, in axes along the eccentricity and
/// across it: of the sum of the surface speeds `rotation_sum` [rad/s] alone, without squeeze and whirl. Its
/// power may have either sign, and it depends on the frame in which the rotations are counted: here the
/// carrier's.
Vector2 printed_film_force(const GuidanceModel& model, double eccentricity, double rotation_sum);

/// Forces between the cage and the ring whose land guides it. The film feels the velocity of the cage less
/// what half the sum of both rotations gives it, so that the force does not depend on the frame.
GuidanceForces guidance_forces(const GuidanceModel& model, const BodyMotion& cage, const BodyMotion& land);

/// Energy stored by touch-down [J].
double guidance_energy(const GuidanceModel& model, const Vector2& cage, const Vector2& land);

}  // namespace orbearing::bearing::dynamics
