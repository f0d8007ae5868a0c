// Inertial loads on a roller or a ring in the frame that turns with the carrier: once, for plain
// numbers and packs. No header of a library here, since files compiled for special instruction sets include
// it.
//
//        y (sense of carrier rotation)
//        ^      e_theta \   / e_r
//        |               \ o   roller, mass m, at (r, theta)
//   sun  |  r_c            |
//    +---+-----> x (outward from the sun axis); origin on the undeformed pin axis
//
#pragma once

namespace orbearing::bearing {

/// Carrier motion with the switches folded in: a term that is switched off has a zero factor.
struct CarrierFrame {
  double coriolis_speed = 0.0;  // [rad/s]    Omega in the Coriolis terms
  double centrifugal = 0.0;     // [rad^2/s^2]  Omega^2 in the centrifugal terms
  double euler = 0.0;           // [rad/s^2]  dOmega/dt in the Euler terms
  double own_orbit = 1.0;       // [-]        1 or 0
  double orbit_radius = 0.0;    // [m]        r_c
};

/// Acceleration [m/s^2] that the frame adds along e_r, outward positive: r (theta' + Omega)^2 + Omega^2 r_c
/// cos theta - dOmega/dt r_c sin theta, term by term so that each can be switched. Corrects Eqs. (28)-(33) of
/// [Gai2025], which lack the Coriolis part 2 Omega r theta'.
template <class Number>
[[gnu::always_inline]] inline Number radial_inertial_acceleration(const CarrierFrame& frame, const Number& r,
                                                                  const Number& cosine, const Number& sine,
                                                                  const Number& theta_speed) {
  const Number speed = r * theta_speed;
  return frame.own_orbit * speed * theta_speed + 2.0 * frame.coriolis_speed * speed +
         frame.centrifugal * (r + frame.orbit_radius * cosine) - frame.euler * frame.orbit_radius * sine;
}

/// Acceleration [m/s^2] that the frame adds along e_theta, without the kinematic 2 r' theta' of polar
/// coordinates.
template <class Number>
[[gnu::always_inline]] inline Number tangential_inertial_acceleration(const CarrierFrame& frame,
                                                                      const Number& r, const Number& cosine,
                                                                      const Number& sine,
                                                                      const Number& radial_speed) {
  return -2.0 * frame.coriolis_speed * radial_speed - frame.centrifugal * frame.orbit_radius * sine -
         frame.euler * (r + frame.orbit_radius * cosine);
}

/// Acceleration [m/s^2] that the frame adds to a body at (`x`, `y`) [m] with velocity (`v_x`, `v_y`) [m/s].
struct PlaneAcceleration {
  double x, y;
};
[[gnu::always_inline]] inline PlaneAcceleration inertial_acceleration(const CarrierFrame& frame, double x,
                                                                      double y, double v_x, double v_y) {
  const double from_sun = x + frame.orbit_radius;
  return {2.0 * frame.coriolis_speed * v_y + frame.centrifugal * from_sun + frame.euler * y,
          -2.0 * frame.coriolis_speed * v_x + frame.centrifugal * y - frame.euler * from_sun};
}

}  // namespace orbearing::bearing
