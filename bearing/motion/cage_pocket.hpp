// Contact of a roller with the bars of its cage pocket: the law of bearing/contact/pocket_law.hpp on both
// bodies, and the film before they touch.
#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/contact/pocket_law.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

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

inline PocketLaw pocket_law(const PocketModel& model) {
  return {model.half_clearance, model.stiffness, model.damping, {model.friction, model.sliding_scale}};
}

/// Forces of roller and bars that touch, in the pocket whose centre line points along `outward` [-] (e), of a
/// roller larger in radius by `larger` [m] than stated.
inline PocketForces touch_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                                 const Vector2& outward, double larger = 0.0) {
  PocketForces forces;
  const PocketLaw law = pocket_law(model);
  const Vector2 ahead = across(outward);
  const Vector2 from_cage = roller.position - cage.position;
  const double offset = from_cage.dot(ahead);
  const double bar = std::copysign(1.0, offset);
  if (law.depth(bar, offset, larger) <= 0.0) return forces;
  const Vector2 velocity = roller.velocity - cage.velocity;
  const auto touch = law.touch(bar, model.roller_radius + larger, larger,
                               PocketMotion{offset, from_cage.dot(outward), velocity.dot(ahead),
                                            velocity.dot(outward), roller.speed, cage.speed});
  const Vector2 force = touch.ahead * ahead + touch.along * outward;
  forces.on_roller = {force, touch.roller_moment};
  forces.on_cage = {-force, touch.cage_moment};
  forces.load = -touch.ahead;
  forces.damping_power = touch.damping_power;
  forces.friction_power = touch.along * touch.sliding;
  return forces;
}

/// Touch and, where the model has it, film at both bars.
PocketForces pocket_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                           const Vector2& outward, double larger = 0.0);

/// Energy stored in the bar [J].
inline double pocket_energy(const PocketModel& model, const Vector2& roller, const Vector2& cage,
                            const Vector2& outward, double larger = 0.0) {
  const double offset = (roller - cage).dot(across(outward));
  const double depth = std::max(0.0, pocket_law(model).depth(std::copysign(1.0, offset), offset, larger));
  return 0.5 * model.stiffness * depth * depth;
}

}  // namespace orbearing::bearing::motion
