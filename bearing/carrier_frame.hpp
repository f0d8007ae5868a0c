// The frame that turns with the carrier from what the user states, and its inertial loads
// (inertial_frame.hpp) by angles and vectors.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "bearing/inertial_frame.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

inline CarrierFrame carrier_frame(const CarrierMotion& motion, const InertiaSwitches& on) {
  return {.coriolis_speed = on.coriolis ? motion.speed : 0.0,
          .centrifugal = on.carrier_centrifugal ? motion.speed * motion.speed : 0.0,
          .euler = on.euler ? motion.acceleration : 0.0,
          .own_orbit = on.own_orbit ? 1.0 : 0.0,
          .orbit_radius = motion.orbit_radius};
}

/// As their namesakes, of a roller at `theta` [rad].
inline double radial_inertial_acceleration(const CarrierFrame& frame, double r, double theta,
                                           double theta_speed) {
  return radial_inertial_acceleration(frame, r, std::cos(theta), std::sin(theta), theta_speed);
}
inline double tangential_inertial_acceleration(const CarrierFrame& frame, double r, double theta,
                                               double radial_speed) {
  return tangential_inertial_acceleration(frame, r, std::cos(theta), std::sin(theta), radial_speed);
}

/// Acceleration of a body at `position` [m] with `velocity` [m/s], both in (x, y).
inline Eigen::Vector2d inertial_acceleration(const CarrierFrame& frame, const Eigen::Vector2d& position,
                                             const Eigen::Vector2d& velocity) {
  const PlaneAcceleration added =
      inertial_acceleration(frame, position.x(), position.y(), velocity.x(), velocity.y());
  return {added.x, added.y};
}

}  // namespace orbearing::bearing
