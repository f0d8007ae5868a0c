#include "bearing/duplex/pair.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/equilibrium/row_group.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::duplex {

namespace {

using equilibrium::RingImbalance;
using equilibrium::RingLoad;
using equilibrium::RingPosition;
using equilibrium::RingState;

}  // namespace

Sides sides_of(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::face_to_face:
      return {1.0, -1.0};
    case Arrangement::back_to_back:
      return {-1.0, 1.0};
    case Arrangement::tandem:
      break;
  }
  return {1.0, 1.0};
}

double approach_under(const Bearing& bearing, double preload) {
  mechanics::require(preload >= 0.0, "preload [N]", preload, "not negative");
  const equilibrium::BallRow row(bearing);
  if (preload == 0.0) return 0.0;
  const RingState state = equilibrium::balance_ring(row, RingLoad{.axial = preload});
  if (!state.report.converged)
    throw std::runtime_error("no static equilibrium under the preload: " + state.report.message);
  return state.axial;
}

PairRow::PairRow(const Pair& pair) : row_(pair.bearing), approach_(pair.approach) {
  const Sides sides = sides_of(pair.arrangement);
  first_ = equilibrium::motion_of_row(pair.levers.first, sides.first, lever(), lever());
  second_ = equilibrium::motion_of_row(-pair.levers.second, sides.second, lever(), lever());
}

RingPosition PairRow::in_row(const Stiffness& motion, const RingPosition& position) const {
  RingPosition own = motion * position;
  own[2] += approach_;
  return own;
}

void PairRow::add_forces(const RingPosition& position, RingImbalance& sum) const {
  for (const Stiffness& motion : {first_, second_}) {
    const RingImbalance one = equilibrium::row_forces(row_, in_row(motion, position));
    sum.force += motion.transpose() * one.force;
    sum.stiffness += motion.transpose() * one.stiffness * motion;
    sum.scale += one.scale;
  }
}

void PairRow::put_loads(const RingPosition& position, RingState& state) const {
  RingState first, second;
  row_.put_loads(in_row(first_, position), first);
  row_.put_loads(in_row(second_, position), second);
  const Eigen::Index balls = row_.count();
  state.contact_load.resize(2 * balls);
  state.contact_load << first.contact_load, second.contact_load;
  state.contact_angle.resize(2 * balls);
  state.contact_angle << first.contact_angle, second.contact_angle;
  state.largest_pressure = std::max(first.largest_pressure, second.largest_pressure);
}

double PairRow::stored_energy(const RingPosition& position) const {
  return row_.stored_energy(in_row(first_, position)) + row_.stored_energy(in_row(second_, position));
}

PairRow::RowStiffnesses PairRow::row_stiffnesses(const RingPosition& position) const {
  const auto of = [&](const Stiffness& motion) {
    return equilibrium::by_tilt(equilibrium::row_forces(row_, in_row(motion, position)).stiffness, lever());
  };
  return {of(first_), of(second_)};
}

namespace {

// What holds the rows together: their approach, or a load.
struct Pressed {
  Pair pair;
  RingLoad load;
  RingPosition start = RingPosition::Zero();
};

// Rows of a tandem are pressed by what draws the shaft along; found from the rows' own force at rest where
// the shaft has moved by the approach.
Pressed pressed(const Pair& pair, const RingLoad& load) {
  Pressed found{pair, load};
  if (pair.arrangement == Arrangement::tandem) {
    found.start[2] = pair.approach;
    found.pair.approach = 0.0;
    found.load.axial -= equilibrium::row_forces(PairRow(found.pair), found.start).force[2];
  }
  return found;
}

}  // namespace

RingState balance_pair_at_speed(const Pair& pair, const equilibrium::RowMotion& motion,
                                const RingLoad& load) {
  const Pressed all = pressed(pair, load);
  const Sides sides = sides_of(pair.arrangement);
  const auto row = [&](double position, double side) {
    return equilibrium::RowOnShaft{.bearing = pair.bearing,
                                   .motion = motion,
                                   .position = position,
                                   .side = side,
                                   .approach = all.pair.approach};
  };
  return equilibrium::balance_rows(
      {row(pair.levers.first, sides.first), row(-pair.levers.second, sides.second)}, all.load);
}

PairState balance_pair(const Pair& pair, const RingLoad& load) {
  const Pressed all = pressed(pair, load);
  const PairRow row(all.pair);
  PairState state{.ring = equilibrium::balance_ring(row, all.load, all.start), .rows = {}};
  state.rows = row.row_stiffnesses(equilibrium::position_of(state.ring, row.lever()));
  return state;
}

Stiffness pair_stiffness(const PairRow::RowStiffnesses& rows, Arrangement arrangement,
                         const RowLevers& levers) {
  constexpr double by_angle = 1.0;
  const Sides sides = sides_of(arrangement);
  const Stiffness first = equilibrium::motion_of_row(levers.first, sides.first, by_angle, by_angle);
  const Stiffness second = equilibrium::motion_of_row(-levers.second, sides.second, by_angle, by_angle);
  return first.transpose() * rows.first * first + second.transpose() * rows.second * second;
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
