// The ball bearing once more, and differently: Cartesian coordinates in an inertial frame, attitudes as
// rotation matrices, velocities of points of rigid bodies, forces with their points of action, Euler's
// equations with the whole tensor of inertia. Nothing turns with a ball, so that no fictitious rate exists to
// be forgotten. Slow and plain. Of the program it takes the constants and the law of a land alone.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/motion/balls/numbers.hpp"

namespace orbearing::reference::inertial_balls {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// A ball, a ring or the cage. The third column of `attitude` is the axis of a ring or the cage, the first
/// one points to the cage's first pocket. As a rate: velocity, acceleration, rates of attitude and turning.
struct Body {
  Vector position = Vector::Zero();      // [m]
  Vector velocity = Vector::Zero();      // [m/s]
  Matrix attitude = Matrix::Identity();  // [-]  not kept of balls
  Vector rotating = Vector::Zero();      // [rad/s]
};

struct Bodies {
  std::vector<Body> balls;
  Body cage, inner, outer;

  /// The bodies after `time` [s] at `rate`.
  Bodies after(double time, const Bodies& rate) const;
};

/// The part of `v` perpendicular to `axis`, a unit vector.
Vector across(const Vector& axis, const Vector& v);

struct Wrench {
  Vector force = Vector::Zero();   // [N]
  Vector moment = Vector::Zero();  // [N m]  about a body's centre

  void add(const Body& body, const Vector& point, const Vector& force_there);
};

/// External loads: of moments the part across a ring's axis. The drives act about it, with moments that give
/// the rings these accelerations.
struct Surroundings {
  double inner_acceleration = 0.0;  // [rad/s^2]
  double outer_acceleration = 0.0;  // [rad/s^2]
  Wrench on_inner, on_outer;
};

/// One contact of a ball with a race or its pocket.
struct Contact {
  double approach = 0.0;       // [m]      <= 0: open
  double load = 0.0;           // [N]
  double contact_angle = 0.0;  // [rad]    of the normal from the bearing's plane
  double sliding = 0.0;        // [m/s]    in the middle, along the direction of rolling
  double spin = 0.0;           // [rad/s]
  double entrainment = 0.0;    // [m/s]
  double film = 0.0;           // [m]
};

/// Power that is lost [W].
struct Losses {
  double friction = 0.0;  // of all points of all ellipses
  double sliding = 0.0;   // of it: as if all points slid as the middle
  double spin = 0.0;      // of it: by the turning about the normal
  double rolling = 0.0;
  double damping = 0.0;
  double pockets = 0.0;
  double lands = 0.0;
  double churning = 0.0;

  double total() const { return friction + rolling + damping + pockets + lands + churning; }
};

struct Outcome {
  Bodies rate;
  std::vector<Contact> inner, outer, pocket;
  int touching_lands = 0;
  Losses loss;
  double inner_torque = 0.0,
         outer_torque = 0.0;   // [N m]  of the drives, against all but the ring's own inertia
  double elastic_power = 0.0;  // [W]    into contacts as springs
};

Outcome outcome(const bearing::balls::BallNumbers& bearing, const Surroundings& around, const Bodies& bodies);

/// Momenta of the whole; rates by `rate` where the rings' rotations about their own axes are in.
struct Momenta {
  Vector linear = Vector::Zero();   // [N s]
  Vector angular = Vector::Zero();  // [N m s]  about the origin
};
/// Rate of the momenta [N], [N m].
Momenta momentum_rate(const bearing::balls::BallNumbers& bearing, const Bodies& bodies, const Bodies& rate);
/// Largest sums of sizes that cancel in it, for the error that rounding may leave [N], [N m].
Momenta momentum_scale(const bearing::balls::BallNumbers& bearing, const Bodies& bodies, const Bodies& rate);
/// Rate of the kinetic energy [W]; without the work of drives on the rings' rotation.
double kinetic_power(const bearing::balls::BallNumbers& bearing, const Bodies& bodies, const Bodies& rate);

}  // namespace orbearing::reference::inertial_balls
