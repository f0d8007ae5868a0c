// Vectors, forces and rigid motion in a plane.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace orbearing::mechanics {

using Vector2 = Eigen::Vector2d;

/// Unit vector at `angle` [rad] from x towards y.
inline Vector2 direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// z x v: `v` turned by a right angle, counter-clockwise.
inline Vector2 across(const Vector2& v) {
  return {-v.y(), v.x()};
}

/// z component of a x b.
inline double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Motion of a rigid body.
struct BodyMotion {
  Vector2 position;    // [m]      of its centre
  Vector2 velocity;    // [m/s]    of its centre
  double speed = 0.0;  // [rad/s]  of its rotation
  double angle = 0.0;  // [rad]    turned since t = 0; used for races that are not round
};

/// Force through the centre of a body and moment about it.
struct Wrench {
  Vector2 force = Vector2::Zero();  // [N]
  double moment = 0.0;              // [N m]

  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
};

/// Wrench of a force [N] that acts at `arm` [m] from the centre of the body.
inline Wrench force_at(const Vector2& arm, const Vector2& force) {
  return {force, cross(arm, force)};
}

}  // namespace orbearing::mechanics
