// Rates of the bodies under the forces of one instant: shared by the equations of a free bore and of a driven
// one.
#pragma once

#include "bearing/motion/instant.hpp"

namespace orbearing::bearing::motion::rates {

inline void set_kinematics(const BearingModel& model, const ConstStateViews& state, MutableStateViews& rate) {
  rate.radius = state.radial_speed;
  rate.angle = state.orbital_speed;
  if (model.layout.caged) {
    rate.cage_position = state.cage_velocity;
    rate.cage_angle = state.cage_speed;
  }
  rate.bore_position = state.bore_velocity;
  rate.pin_position = state.pin_velocity;
  rate.wave = state.wave_speed;
  rate.wave_speed.setZero();
}

inline void set_turning(const BearingModel& model, const ConstStateViews& state, MutableStateViews& rate) {
  for (const RollerScratch& scratch : model.roller_scratches)
    rate.turned[scratch.followed] = state.spin[scratch.roller];
}

// Newton and Euler for one roller in polar coordinates; 2 r' theta' is kinematic. Forces that pass through
// memory on the way here cost a third of the right-hand side: hence inline.
[[gnu::always_inline]] inline void set_roller(const BearingModel& model, const CarrierFrame& frame,
                                              const RollerBody& roller, const RollerForces& forces,
                                              const Wrench& neighbours, Eigen::Index j,
                                              MutableStateViews& rate) {
  const Vector2 force = forces.inner.on_roller.force + forces.outer.on_roller.force +
                        forces.pocket.on_roller.force + neighbours.force;
  const double moment = forces.inner.on_roller.moment + forces.outer.on_roller.moment +
                        forces.pocket.on_roller.moment + forces.spin_drag + neighbours.moment;
  const double mass = model.roller.mass;
  rate.radial_speed[j] =
      force.dot(roller.outward) / mass +
      radial_inertial_acceleration(frame, roller.radius, roller.angle, roller.orbital_speed);
  rate.orbital_speed[j] =
      ((force.dot(across(roller.outward)) + forces.orbit_drag) / mass +
       tangential_inertial_acceleration(frame, roller.radius, roller.angle, roller.radial_speed) -
       2.0 * roller.radial_speed * roller.orbital_speed) /
      roller.radius;
  rate.spin[j] = moment / model.roller.inertia - frame.euler;
  if (model.layout.tilting) rate.end_displacement[j] = forces.tip_rate;
}

// Rollers, with what they exert on the rings. `forces_on` is roller_forces, or plain_roller_forces where the
// model allows.
template <auto forces_on>
void set_rollers(const BearingModel& model, const CarrierFrame& frame, const ConstStateViews& state,
                 const RingBodies& rings, RingWrenches& on_rings, MutableStateViews& rate) {
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const RollerBody roller = roller_body(model, state, j);
    const RollerForces forces = forces_on(model, rings, roller, j);
    set_roller(model, frame, roller, forces, neighbour_forces(model, state, roller, j).on_roller(), j, rate);
    on_rings.add(forces);
    if (model.layout.waves > 0) add_wave_forces(forces.outer.load, forces.outer_normal, rate.wave_speed);
  }
}

// The waves of an elastic race under the loads of the rollers, which set_rollers() has put into their rates, and
// under forces of the teeth that are `meshes` [-] times their means.
inline void set_waves(const BearingModel& model, const ConstStateViews& state, double meshes,
                      MutableStateViews& rate) {
  const RimModel& rim = model.rim;
  for (Eigen::Index i = 0; i < model.layout.waves; ++i)
    rate.wave_speed[i] = (rate.wave_speed[i] - rim.damping[i] * state.wave_speed[i] -
                          rim.stiffness[i] * (state.wave[i] - meshes * rim.at_rest[i])) /
                         rim.mass[i];
}

inline void set_cage(const BearingModel& model, const CarrierFrame& frame, const BodyMotion& cage,
                     const Wrench& wrench, MutableStateViews& rate) {
  if (!model.layout.caged) return;
  rate.cage_velocity =
      wrench.force / model.cage.mass + inertial_acceleration(frame, cage.position, cage.velocity);
  rate.cage_speed = (wrench.moment + model.cage_drag.force(cage.speed)) / model.cage.inertia - frame.euler;
}

inline void set_pin(const BearingModel& model, const CarrierFrame& frame, const BodyMotion& pin,
                    const Vector2& force, MutableStateViews& rate) {
  rate.pin_velocity = (force + model.support.force(pin.position, pin.velocity)) / model.pin_mass +
                      inertial_acceleration(frame, pin.position, pin.velocity);
}

}  // namespace orbearing::bearing::motion::rates
