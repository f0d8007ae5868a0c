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
  double viscous = 0.0;         // [Pa s m]  2 eta l of the oil before the bars; 0: none
  double roughness = 0.0;       // [m]       least gap of that oil

  bool with_film() const { return viscous > 0.0; }
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
  return {model.half_clearance, model.stiffness, model.damping, {model.friction, model.sliding_scale},
          model.viscous,        model.roughness};
}

/// In the axes of the pocket whose centre line points along `outward` [-] (e).
inline PocketMotion<double, double, double, double, double, double> pocket_motion(const BodyMotion& roller,
                                                                                  const BodyMotion& cage,
                                                                                  const Vector2& outward) {
  const Vector2 ahead = across(outward), from_cage = roller.position - cage.position;
  const Vector2 velocity = roller.velocity - cage.velocity;
  return {from_cage.dot(ahead),  from_cage.dot(outward), velocity.dot(ahead),
          velocity.dot(outward), roller.speed,           cage.speed};
}

/// Forces of roller and bars that touch, in the pocket whose centre line points along `outward` [-] (e), of a
/// roller larger in radius by `larger` [m] than stated.
inline PocketForces touch_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                                 const Vector2& outward, double larger = 0.0) {
  PocketForces forces;
  const PocketLaw law = pocket_law(model);
  const PocketMotion motion = pocket_motion(roller, cage, outward);
  const double bar = std::copysign(1.0, motion.offset);
  if (law.depth(bar, motion.offset, larger) <= 0.0) return forces;
  const auto touch = law.touch(bar, model.roller_radius + larger, larger, motion);
  const Vector2 force = touch.ahead * across(outward) + touch.along * outward;
  forces.on_roller = {force, touch.roller_moment};
  forces.on_cage = {-force, touch.cage_moment};
  forces.load = -touch.ahead;
  forces.damping_power = touch.power;
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
