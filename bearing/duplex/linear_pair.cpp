#include "bearing/duplex/linear_pair.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::bearing::duplex {

PressedRow pressed_row(const Bearing& bearing, double approach) {
  const equilibrium::BallRow row(bearing);
  equilibrium::RingPosition position = equilibrium::RingPosition::Zero();
  position[2] = approach;
  const equilibrium::BallRow::BallPosition ball = row.position_of(0, position);
  const double root = std::sqrt(std::max(0.0, ball.approach));
  return {.angle = std::atan2(ball.axial, ball.radial),
          .normal_stiffness = 1.5 * row.constant() * root,
          .groove_circle = row.lever(),
          .load = row.constant() * root * root * root,
          .ball_angle = equilibrium::element_angles(bearing)};
}

// Eqs. (7) to (10) and (14): each ball resists along its line of contact alone.
Stiffness linear_stiffness(const PressedRow& row, const RowLevers& levers) {
  const double cosine = std::cos(row.angle), sine = std::sin(row.angle);
  Stiffness sum = Stiffness::Zero();
  for (const double position : {levers.first, -levers.second}) {
    const double by_tilt = row.groove_circle * sine - position * cosine;
    for (const double angle : row.ball_angle) {
      const double x = std::cos(angle), y = std::sin(angle);
      const Eigen::Vector<double, 5> approach(x * cosine, y * cosine, sine, x * by_tilt, y * by_tilt);
      sum += row.normal_stiffness * approach * approach.transpose();
    }
  }
  return sum;
}

}  // namespace orbearing::bearing::duplex
