#include "bearing/duplex/pair.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/checks.hpp"
#include "mechanics/no_result.hpp"

namespace orbearing::bearing::duplex {

using equilibrium::RingLoad;
using equilibrium::RingPosition;
using equilibrium::RingState;

namespace {

// Towards which side both rows are pressed: +1 towards the first row's end of the shaft.
struct Sides {
  double first = 1.0;
  double second = 1.0;
};

Sides sides_of(Arrangement arrangement) {
  return {arrangement == Arrangement::back_to_back ? -1.0 : 1.0,
          arrangement == Arrangement::face_to_face ? -1.0 : 1.0};
}

}  // namespace

double approach_under(const Bearing& bearing, double preload) {
  mechanics::require(preload >= 0.0, "preload [N]", preload, "not negative");
  const equilibrium::BallRow row(bearing);
  if (preload == 0.0) return 0.0;
  const RingState state = equilibrium::balance_ring(row, RingLoad{.axial = preload});
  if (!state.report.converged)
    throw mechanics::NoResult("no static equilibrium under the preload: " + state.report.message);
  return state.axial;
}

std::vector<equilibrium::RowOnShaft> rows_of(const Pair& pair, const equilibrium::RowMotion& motion) {
  const Sides sides = sides_of(pair.arrangement);
  const auto row = [&](double position, double side) {
    return equilibrium::RowOnShaft{pair.bearing, motion, position, side, pair.approach};
  };
  return {row(pair.levers.first, sides.first), row(-pair.levers.second, sides.second)};
}

namespace {

// Preload of the rows: their approach, or a load.
struct Pressed {
  Pair pair;
  RingLoad load;
  RingPosition start = RingPosition::Zero();
};

// The rows of a tandem are preloaded by an axial load of the shaft; it is found from the rows' own force at
// rest with the shaft displaced by the approach.
Pressed pressed(const Pair& pair, const RingLoad& load) {
  Pressed found{pair, load};
  if (pair.arrangement == Arrangement::tandem) {
    found.start[2] = pair.approach;
    found.pair.approach = 0.0;
    found.load.axial -=
        equilibrium::row_forces(equilibrium::RowGroup(rows_of(found.pair)), found.start).force[2];
  }
  return found;
}

}  // namespace

RingState balance_pair_at_speed(const Pair& pair, const equilibrium::RowMotion& motion,
                                const RingLoad& load) {
  const Pressed all = pressed(pair, load);
  return equilibrium::balance_rows(rows_of(all.pair, motion), all.load);
}

PairState balance_pair(const Pair& pair, const RingLoad& load) {
  const Pressed all = pressed(pair, load);
  const equilibrium::RowGroup rows(rows_of(all.pair));
  const RingState ring = equilibrium::balance_ring(rows, all.load, all.start);
  return {ring, rows.row_stiffnesses(equilibrium::position_of(ring, rows.lever()))};
}

Stiffness pair_stiffness(const std::vector<Stiffness>& rows, Arrangement arrangement,
                         const RowLevers& levers) {
  constexpr double by_angle = 1.0;
  const Sides sides = sides_of(arrangement);
  const Stiffness first = equilibrium::motion_of_row(levers.first, sides.first, by_angle, by_angle);
  const Stiffness second = equilibrium::motion_of_row(-levers.second, sides.second, by_angle, by_angle);
  return first.transpose() * rows[0] * first + second.transpose() * rows[1] * second;
}

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

// Eqs. (7) to (10) and (14): each ball resists along its line of contact only.
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
