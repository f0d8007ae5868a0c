// Contact of a roller with the bars of its cage pocket.
//
//        n (sense of rotation)        The pocket's centre line runs from the cage centre along e, at the cage
//        angle ^   |bar|                    plus the pocket's own. The roller stands off it by s along n and
//        touches a bar |   ( o ) roller             where |s| exceeds half the clearance.
//   o----|---|---|---> e
//  cage      |bar|
//
#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/contact/friction.hpp"
#include "bearing/motion/contact_damping.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::dynamics {

/// One pocket, fixed for a run.
struct PocketModel {
  double half_clearance = 0.0;  // [m]
  double stiffness = 0.0;       // [N/m]
  double damping = 0.0;         // [s/m]
  double friction = 0.0;        // [-]
  double sliding_scale = 0.0;   // [m/s]
  double roller_radius = 0.0;   // [m]
  bool with_film = false;
  double viscosity = 0.0;  // [Pa s]
  double length = 0.0;     // [m]     of the film: the roller's
  double roughness = 0.0;  // [m]     least gap of the film
};

/// Forces between a roller and its pocket.
struct PocketForces {
  Wrench on_roller;
  Wrench on_cage;
  double load = 0.0;  // [N]  signed: positive where the roller pushes the cage in the sense of rotation
  double damping_power = 0.0;   // [W]  dissipated
  double friction_power = 0.0;  // [W]  dissipated
  double film_power = 0.0;      // [W]  dissipated
};

/// Forces of roller and bars that touch, in the pocket whose centre line points along `outward` [-] (e), of a
/// roller larger in radius by `larger` [m] than stated.
inline PocketForces touch_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                                 const Vector2& outward, double larger = 0.0) {
  PocketForces forces;
  const Vector2 ahead = across(outward);
  const Vector2 from_cage = roller.position - cage.position;
  const double offset = from_cage.dot(ahead);
  const double depth = std::abs(offset) - (model.half_clearance - larger);
  if (depth <= 0.0) return forces;
  const double bar = std::copysign(1.0, offset);
  const Vector2 relative_velocity = roller.velocity - cage.velocity;
  const double depth_speed = bar * (relative_velocity.dot(ahead) - cage.speed * from_cage.dot(outward));
  const DampedLoad normal = damped_load(model.stiffness * depth, model.damping, depth_speed);

  const double radius = model.roller_radius + larger;
  const Vector2 to_bar = bar * radius * ahead;
  const double sliding =
      -relative_velocity.dot(outward) - cage.speed * (offset + bar * radius) + roller.speed * bar * radius;
  const double friction =
      CoulombFriction<double>{model.friction, model.sliding_scale}.force(normal.load, sliding);
  const Vector2 force = -bar * normal.load * ahead + friction * outward;
  forces.on_roller = force_at(to_bar, force);
  forces.on_cage = force_at(from_cage + to_bar, -force);
  forces.load = bar * normal.load;
  forces.damping_power = normal.power;
  forces.friction_power = friction * sliding;
  return forces;
}

/// Touch and, where the model has it, film at both bars.
PocketForces pocket_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                           const Vector2& outward, double larger = 0.0);

/// Energy stored in the bar [J].
inline double pocket_energy(const PocketModel& model, const Vector2& roller, const Vector2& cage,
                            const Vector2& outward, double larger = 0.0) {
  const double depth =
      std::max(0.0, std::abs((roller - cage).dot(across(outward))) - (model.half_clearance - larger));
  return 0.5 * model.stiffness * depth * depth;
}

}  // namespace orbearing::bearing::dynamics
