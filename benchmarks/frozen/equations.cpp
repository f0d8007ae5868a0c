#include "benchmarks/frozen/equations.hpp"

#include <cmath>
#include <type_traits>

namespace orbearing::bench::frozen {

namespace {

template <typename Scalar>
struct StateViews {
  template <typename Plain>
  using View = Eigen::Map<std::conditional_t<std::is_const_v<Scalar>, const Plain, Plain>>;

  View<Eigen::ArrayXd> radius, angle, radial_speed, orbital_speed, spin;  // (rollers)
  View<Eigen::Vector2d> cage_position;
  Scalar& cage_angle;
  View<Eigen::Vector2d> cage_velocity;
  Scalar& cage_speed;
  View<Eigen::Vector2d> bore_position, bore_velocity, pin_position, pin_velocity;
};

template <typename Scalar>
StateViews<Scalar> views(Eigen::Index z, Scalar* x) {
  Scalar* cage = x + 5 * z;
  Scalar* bore = cage + 6;
  Scalar* pin = bore + 4;
  using Pair = typename StateViews<Scalar>::template View<Eigen::Vector2d>;
  return {{x, z},         {x + z, z}, {x + 2 * z, z}, {x + 3 * z, z}, {x + 4 * z, z}, Pair(cage),   cage[2],
          Pair(cage + 3), cage[5],    Pair(bore),     Pair(bore + 2), Pair(pin),      Pair(pin + 2)};
}

using ConstStateViews = StateViews<const double>;
using MutableStateViews = StateViews<double>;

double radial_inertial_acceleration(const CarrierFrame& frame, double r, double theta, double theta_speed) {
  return frame.own_orbit * r * theta_speed * theta_speed + 2.0 * frame.coriolis_speed * r * theta_speed +
         frame.centrifugal * (r + frame.orbit_radius * std::cos(theta)) -
         frame.euler * frame.orbit_radius * std::sin(theta);
}

double tangential_inertial_acceleration(const CarrierFrame& frame, double r, double theta,
                                        double radial_speed) {
  return -2.0 * frame.coriolis_speed * radial_speed -
         frame.centrifugal * frame.orbit_radius * std::sin(theta) -
         frame.euler * (r + frame.orbit_radius * std::cos(theta));
}

Vector2 inertial_acceleration(const CarrierFrame& frame, const Vector2& position, const Vector2& velocity) {
  const Vector2 from_sun(position.x() + frame.orbit_radius, position.y());
  const Vector2 across_velocity(velocity.y(), -velocity.x());
  const Vector2 across_position(from_sun.y(), -from_sun.x());
  return 2.0 * frame.coriolis_speed * across_velocity + frame.centrifugal * from_sun +
         frame.euler * across_position;
}

struct RingBodies {
  BodyMotion cage, bore, pin;
  Vector2 cage_direction;  // [-]  of the cage angle
};

RingBodies ring_bodies(const Model& model, const ConstStateViews& state) {
  return {.cage = {state.cage_position, state.cage_velocity, state.cage_speed},
          .bore = {state.bore_position, state.bore_velocity, model.outer_speed},
          .pin = {state.pin_position, state.pin_velocity, model.inner_speed},
          .cage_direction = {std::cos(state.cage_angle), std::sin(state.cage_angle)}};
}

struct RollerBody {
  BodyMotion motion;
  Vector2 outward;             // [-]      e_r
  double radius = 0.0;         // [m]
  double angle = 0.0;          // [rad]
  double radial_speed = 0.0;   // [m/s]
  double orbital_speed = 0.0;  // [rad/s]
};

RollerBody roller_body(const ConstStateViews& state, Eigen::Index j) {
  RollerBody roller;
  roller.radius = state.radius[j];
  roller.angle = state.angle[j];
  roller.radial_speed = state.radial_speed[j];
  roller.orbital_speed = state.orbital_speed[j];
  roller.outward = {std::cos(roller.angle), std::sin(roller.angle)};
  roller.motion.position = roller.radius * roller.outward;
  roller.motion.velocity =
      roller.radial_speed * roller.outward + roller.radius * roller.orbital_speed * across(roller.outward);
  roller.motion.speed = state.spin[j];
  return roller;
}

struct RollerForces {
  RaceForces inner, outer;
  PocketForces pocket;
  double orbit_drag = 0.0;  // [N]    along e_theta
  double spin_drag = 0.0;   // [N m]
};

Vector2 pocket_direction(const Model& model, const RingBodies& rings, Eigen::Index j) {
  const Vector2& own = model.pocket_direction[static_cast<std::size_t>(j)];
  return own.x() * rings.cage_direction + own.y() * across(rings.cage_direction);
}

RollerForces roller_forces(const Model& model, const RingBodies& rings, const RollerBody& roller,
                           Eigen::Index j) {
  return {.inner = race_forces(model.inner, roller.motion, rings.pin),
          .outer = race_forces(model.outer, roller.motion, rings.bore),
          .pocket = touch_forces(model.pocket, roller.motion, rings.cage, pocket_direction(model, rings, j)),
          .orbit_drag = model.orbit_drag.force(roller.radius * roller.orbital_speed),
          .spin_drag = model.spin_drag.force(roller.motion.speed)};
}

struct RingWrenches {
  Wrench cage, bore, pin;

  void add(const RollerForces& forces) {
    pin += forces.inner.on_race;
    bore += forces.outer.on_race;
    cage += forces.pocket.on_cage;
  }
  void add(const GuidanceForces& forces) {
    cage += forces.on_cage;
    bore += forces.on_land;
  }
};

void set_kinematics(const ConstStateViews& state, MutableStateViews& rate) {
  rate.radius = state.radial_speed;
  rate.angle = state.orbital_speed;
  rate.cage_position = state.cage_velocity;
  rate.cage_angle = state.cage_speed;
  rate.bore_position = state.bore_velocity;
  rate.pin_position = state.pin_velocity;
}

// Forces that pass through memory on the way here cost a third of the right-hand side: hence inline.
[[gnu::always_inline]] inline void set_roller(const Model& model, const CarrierFrame& frame,
                                              const RollerBody& roller, const RollerForces& forces,
                                              Eigen::Index j, MutableStateViews& rate) {
  const Vector2 force =
      forces.inner.on_roller.force + forces.outer.on_roller.force + forces.pocket.on_roller.force;
  const double moment = forces.inner.on_roller.moment + forces.outer.on_roller.moment +
                        forces.pocket.on_roller.moment + forces.spin_drag;
  const double mass = model.roller_mass;
  rate.radial_speed[j] =
      force.dot(roller.outward) / mass +
      radial_inertial_acceleration(frame, roller.radius, roller.angle, roller.orbital_speed);
  rate.orbital_speed[j] =
      ((force.dot(across(roller.outward)) + forces.orbit_drag) / mass +
       tangential_inertial_acceleration(frame, roller.radius, roller.angle, roller.radial_speed) -
       2.0 * roller.radial_speed * roller.orbital_speed) /
      roller.radius;
  rate.spin[j] = moment / model.roller_inertia - frame.euler;
}

void set_cage(const Model& model, const BodyMotion& cage, const Wrench& wrench, MutableStateViews& rate) {
  rate.cage_velocity =
      wrench.force / model.cage_mass + inertial_acceleration(model.frame, cage.position, cage.velocity);
  rate.cage_speed =
      (wrench.moment + model.cage_drag.force(cage.speed)) / model.cage_inertia - model.frame.euler;
}

// The load on the bore holds the planet's inertial load at the origin: here only what its displacement adds.
void set_bore(const Model& model, const BodyMotion& bore, const Vector2& force, MutableStateViews& rate) {
  CarrierFrame centred = model.frame;
  centred.orbit_radius = 0.0;
  rate.bore_velocity = force / model.bore_mass + inertial_acceleration(centred, bore.position, bore.velocity);
}

void set_pin(const Model& model, const BodyMotion& pin, const Vector2& force, MutableStateViews& rate) {
  const Vector2 support = -model.support_stiffness * pin.position - model.support_damping * pin.velocity;
  rate.pin_velocity =
      (force + support) / model.pin_mass + inertial_acceleration(model.frame, pin.position, pin.velocity);
}

}  // namespace

void Equations::derivative(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) const {
  const ConstStateViews state = views(model_.rollers, x.data());
  MutableStateViews rate = views(model_.rollers, dx.data());
  const RingBodies rings = ring_bodies(model_, state);
  RingWrenches on_rings;

  set_kinematics(state, rate);
  for (Eigen::Index j = 0; j < model_.rollers; ++j) {
    const RollerBody roller = roller_body(state, j);
    const RollerForces forces = roller_forces(model_, rings, roller, j);
    set_roller(model_, model_.frame, roller, forces, j, rate);
    on_rings.add(forces);
  }
  on_rings.add(guidance_forces(model_.guidance, rings.cage, rings.bore));
  set_cage(model_, rings.cage, on_rings.cage, rate);
  set_bore(model_, rings.bore, on_rings.bore.force + model_.bore_load, rate);
  set_pin(model_, rings.pin, on_rings.pin.force, rate);
}

}  // namespace orbearing::bench::frozen
