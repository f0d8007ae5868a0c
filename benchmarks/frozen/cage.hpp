// Frozen: a roller in its pocket and the cage on its land, as commit d33b5f5 had them.
#pragma once

#include <cmath>

#include "benchmarks/frozen/contact.hpp"

namespace orbearing::bench::frozen {

struct Pocket {
  double half_clearance = 0.0;  // [m]
  double stiffness = 0.0;       // [N/m]
  double damping = 0.0;         // [s/m]
  double friction = 0.0;        // [-]
  double sliding_scale = 0.0;   // [m/s]
  double roller_radius = 0.0;   // [m]
};

struct PocketForces {
  Wrench on_roller;
  Wrench on_cage;
};

/// Forces of roller and bars that touch, in the pocket whose centre line points along `outward` [-].
inline PocketForces touch_forces(const Pocket& model, const BodyMotion& roller, const BodyMotion& cage,
                                 const Vector2& outward) {
  PocketForces forces;
  const Vector2 ahead = across(outward);
  const Vector2 from_cage = roller.position - cage.position;
  const double offset = from_cage.dot(ahead);
  const double depth = std::abs(offset) - model.half_clearance;
  if (depth <= 0.0) return forces;
  const double bar = std::copysign(1.0, offset);
  const Vector2 relative_velocity = roller.velocity - cage.velocity;
  const double depth_speed = bar * (relative_velocity.dot(ahead) - cage.speed * from_cage.dot(outward));
  const double load = damped_load(model.stiffness * depth, model.damping, depth_speed);

  const double radius = model.roller_radius;
  const Vector2 to_bar = bar * radius * ahead;
  const double sliding =
      -relative_velocity.dot(outward) - cage.speed * (offset + bar * radius) + roller.speed * bar * radius;
  const double friction = regularised_friction(model.friction, load, sliding, model.sliding_scale);
  const Vector2 force = -bar * load * ahead + friction * outward;
  forces.on_roller = force_at(to_bar, force);
  forces.on_cage = force_at(from_cage + to_bar, -force);
  return forces;
}

/// Land and oil: a short journal bearing with squeeze and whirl, and touch-down.
struct Guidance {
  double side = 1.0;                  // [-]      +1: the land is outside the cage, -1: inside
  double clearance = 0.0;             // [m]      radial
  double cage_radius = 0.0;           // [m]
  double film_scale = 0.0;            // [N s/m]  LandLaw's, as the next one
  double shear_scale = 0.0;           // [N m s]
  double largest_eccentricity = 0.0;  // [-]
  double stiffness = 0.0;             // [N/m]
  double damping = 0.0;               // [s/m]
  double friction = 0.0;              // [-]
  double sliding_scale = 0.0;         // [m/s]
};

struct GuidanceForces {
  Wrench on_cage;
  Wrench on_land;
};

GuidanceForces guidance_forces(const Guidance& model, const BodyMotion& cage, const BodyMotion& land);

}  // namespace orbearing::bench::frozen
