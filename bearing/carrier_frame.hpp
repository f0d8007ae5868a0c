// Inertial loads that a roller or a ring feels in the frame that turns with the carrier.
//
//        y (sense of carrier rotation)
//        ^      e_theta \   / e_r
//        |               \ o   roller, mass m, at (r, theta)
//   sun  |  r_c            |
//    +---+-----> x (outward from the sun axis); origin on the undeformed pin axis
//
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Carrier motion with the switches folded in: a term that is switched off has a zero factor.
struct CarrierFrame {
  double coriolis_speed = 0.0;  // [rad/s]    Omega in the Coriolis terms
  double centrifugal = 0.0;     // [rad^2/s^2]  Omega^2 in the centrifugal terms
  double euler = 0.0;           // [rad/s^2]  dOmega/dt in the Euler terms
  double own_orbit = 1.0;       // [-]        1 or 0
  double orbit_radius = 0.0;    // [m]        r_c
};

inline CarrierFrame carrier_frame(const CarrierMotion& motion, const InertiaSwitches& on) {
  return {.coriolis_speed = on.coriolis ? motion.speed : 0.0,
          .centrifugal = on.carrier_centrifugal ? motion.speed * motion.speed : 0.0,
          .euler = on.euler ? motion.acceleration : 0.0,
          .own_orbit = on.own_orbit ? 1.0 : 0.0,
          .orbit_radius = motion.orbit_radius};
}

/// Acceleration [m/s^2] that the frame adds along e_r, outward positive: r (theta' + Omega)^2 + Omega^2 r_c
/// cos theta - dOmega/dt r_c sin theta, term by term so that each can be switched. Corrects Eqs. (28)-(33) of
/// [Gai2025], which lack the Coriolis part 2 Omega r theta'.
inline double radial_inertial_acceleration(const CarrierFrame& frame, double r, double theta,
                                           double theta_speed) {
  return frame.own_orbit * r * theta_speed * theta_speed + 2.0 * frame.coriolis_speed * r * theta_speed +
         frame.centrifugal * (r + frame.orbit_radius * std::cos(theta)) -
         frame.euler * frame.orbit_radius * std::sin(theta);
}

/// Acceleration [m/s^2] that the frame adds along e_theta, without the kinematic 2 r' theta' of polar
/// coordinates.
inline double tangential_inertial_acceleration(const CarrierFrame& frame, double r, double theta,
                                               double radial_speed) {
  return -2.0 * frame.coriolis_speed * radial_speed -
         frame.centrifugal * frame.orbit_radius * std::sin(theta) -
         frame.euler * (r + frame.orbit_radius * std::cos(theta));
}

/// Acceleration [m/s^2] that the frame adds to a body at `position` [m] with `velocity` [m/s], both in (x,
/// y).
inline Eigen::Vector2d inertial_acceleration(const CarrierFrame& frame, const Eigen::Vector2d& position,
                                             const Eigen::Vector2d& velocity) {
  const Eigen::Vector2d from_sun(position.x() + frame.orbit_radius, position.y());
  const Eigen::Vector2d across_velocity(velocity.y(), -velocity.x());
  const Eigen::Vector2d across_position(from_sun.y(), -from_sun.x());
  return 2.0 * frame.coriolis_speed * across_velocity + frame.centrifugal * from_sun +
         frame.euler * across_position;
}

}  // namespace orbearing::bearing
