// The port of a planet bearing: the prescribed motion of its bore, and its reaction.
#pragma once

#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

/// Motion of the planet's bore and of the carrier at one instant. The bore's inertia belongs to the model
/// that prescribes the motion; pin ring and pin support belong to the bearing.
struct BoreMotion {
  Vector2 position = Vector2::Zero();      // [m]      of the bore's axis from the undeformed pin axis, (x, y)
  Vector2 velocity = Vector2::Zero();      // [m/s]
  Vector2 acceleration = Vector2::Zero();  // [m/s^2]  used by implicit integrators only
  double speed = 0.0;                      // [rad/s]  of the bore, relative to the carrier
  double angle = 0.0;  // [rad]    turned by the bore since the start; used for bores that are not round
  double carrier_angle = 0.0;         // [rad]    turned by the carrier since the start; used if gravity acts
  double carrier_speed = 0.0;         // [rad/s]
  double carrier_acceleration = 0.0;  // [rad/s^2]
};

/// Reaction of the bearing on the planet: sum of the forces of rollers, film and, where the outer ring guides
/// it, the cage on the bore.
using BoreReaction = Wrench;

/// Exchange of power between a bearing and its bore at one instant.
struct BorePort {
  double speed = 0.0;   // [rad/s]  of the bore relative to the carrier
  double moment = 0.0;  // [N m]    of the bearing on the bore
  double travel = 0.0;  // [W]      force of the bearing on the bore times the velocity of the bore's axis
};

inline BorePort bore_port(const BoreReaction& on_bore, double speed, const Vector2& velocity) {
  return {speed, on_bore.moment, on_bore.force.dot(velocity)};
}

}  // namespace orbearing::bearing::motion
