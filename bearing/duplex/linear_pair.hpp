// Stiffness of a face-to-face pair by the linear formulas (9) to (14) of [FangDuplex], with the contact angle
// that the preload makes. Literature variant: the axial approach has one sign in both rows, as the source
// prints it; two rows that face each other have opposite ones. It leaves out the geometric stiffness too.
#pragma once

#include "bearing/duplex/pair.hpp"

namespace orbearing::bearing::duplex {

/// How one row is pressed, the same at each ball.
struct PressedRow {
  double angle = 0.0;             // [rad]  contact angle under preload
  double normal_stiffness = 0.0;  // [N/m]  1.5 k delta^0.5 of one ball, Eq. (12)
  double groove_circle = 0.0;     // [m]    radius of the inner groove's centres, R_i
  double load = 0.0;              // [N]    on one ball
  Eigen::ArrayXd ball_angle;      // [rad]  (balls)
};

/// The row pressed along its axis by `approach` [m]. Throws std::invalid_argument as BallRow does.
PressedRow pressed_row(const Bearing& bearing, double approach);

/// In the coordinates of pair.hpp, about the shaft's mass centre.
Stiffness linear_stiffness(const PressedRow& row, const RowLevers& levers);

}  // namespace orbearing::bearing::duplex
