#include "bearing/equilibrium/row_group.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "mechanics/checks.hpp"
#include "mechanics/path_search.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

void append(const Eigen::ArrayXd& more, Eigen::ArrayXd& all) {
  const Eigen::Index before = all.size();
  all.conservativeResize(before + more.size());
  all.tail(more.size()) = more;
}

bool feels_its_motion(const RowOnShaft& one) {
  return !one.bearing.has_rollers() && one.motion.moves_balls();
}

}  // namespace

RowGroup::RowGroup(const std::vector<RowOnShaft>& bearings) {
  mechanics::require(!bearings.empty(), "rows", 0.0, "at least one");
  for (const RowOnShaft& one : bearings) {
    mechanics::require(std::abs(one.side) == 1.0, "side of a row", one.side, "+1 or -1");
    if (one.bearing.has_rollers())
      rows_.push_back({.row = RollerRow(one.bearing)});
    else
      rows_.push_back({.row = BallRow(one.bearing), .approach = one.approach});
    lever_ = std::max(lever_, rows_.back().bearing().lever());
  }
  for (std::size_t k = 0; k < rows_.size(); ++k)
    rows_[k].motion =
        motion_of_row(bearings[k].position, bearings[k].side, lever_, rows_[k].bearing().lever());
}

RowGroup::RowGroup(const RowGroup& at_rest, const std::vector<RowOnShaft>& bearings) : RowGroup(at_rest) {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (!feels_its_motion(bearings[k])) continue;
    const BallRow& balls = std::get<BallRow>(at_rest.rows_[k].row);
    rows_[k].row.emplace<JonesRow>(bearings[k].bearing, bearings[k].motion, balls);
    positions_ += 2 * balls.count();
  }
}

RingPosition RowGroup::Placed::in_row(const RingPosition& position) const {
  RingPosition own = motion * position;
  own[2] += approach;
  return own;
}

double RowGroup::reach(double load) const {
  double longest = 0.0;
  for (const Placed& one : rows_)
    longest = std::max(longest, std::abs(one.approach) + one.bearing().reach(load));
  return longest;
}

void RowGroup::add_forces(const RingPosition& position, RingImbalance& sum) const {
  for (const Placed& one : rows_) {
    const RingImbalance own = row_forces(one.bearing(), one.in_row(position));
    sum.force += one.motion.transpose() * own.force;
    sum.stiffness += one.motion.transpose() * own.stiffness * one.motion;
    sum.scale += own.scale;
  }
}

void RowGroup::put_loads(const RingPosition& position, RingState& state) const {
  for (Placed& one : rows_) {
    RingState own;
    one.bearing().put_loads(one.in_row(position), own);
    if (rows_.size() == 1) state.lamina_load = own.lamina_load;
    append(own.contact_load, state.contact_load);
    append(own.contact_angle, state.contact_angle);
    append(own.outer_load, state.outer_load);
    append(own.outer_angle, state.outer_angle);
    append(own.inner_rolling, state.inner_rolling);
    append(own.inner_spin, state.inner_spin);
    append(own.outer_rolling, state.outer_rolling);
    append(own.outer_spin, state.outer_spin);
    const Eigen::Index before = state.ball_position.cols();
    state.ball_position.conservativeResize(2, before + own.ball_position.cols());
    state.ball_position.rightCols(own.ball_position.cols()) = own.ball_position;
    state.inner_control.insert(state.inner_control.end(), own.inner_control.begin(), own.inner_control.end());
    state.friction = std::max(state.friction, own.friction);
    state.largest_pressure = std::max(state.largest_pressure, own.largest_pressure);
  }
}

std::vector<Eigen::Matrix<double, 5, 5>> RowGroup::row_stiffnesses(const RingPosition& position) const {
  std::vector<Eigen::Matrix<double, 5, 5>> all;
  for (const Placed& one : rows_)
    all.push_back(by_tilt(row_forces(one.bearing(), one.in_row(position)).stiffness, one.bearing().lever()));
  return all;
}

std::vector<JonesRow*> RowGroup::rotating() const {
  std::vector<JonesRow*> all;
  for (Placed& one : rows_)
    if (JonesRow* balls = one.rotating()) all.push_back(balls);
  return all;
}

bool RowGroup::follows_motion() const {
  const std::vector<JonesRow*> all = rotating();
  return std::any_of(all.begin(), all.end(), std::mem_fn(&JonesRow::follows_motion));
}

bool RowGroup::settled() const {
  const std::vector<JonesRow*> all = rotating();
  return std::all_of(all.begin(), all.end(), std::mem_fn(&JonesRow::settled));
}

bool RowGroup::has_stiffness() const {
  const std::vector<JonesRow*> all = rotating();
  return std::all_of(all.begin(), all.end(), std::mem_fn(&JonesRow::has_stiffness));
}

bool RowGroup::choose_control() {
  bool changed = false;
  for (JonesRow* balls : rotating()) changed = balls->choose_control() || changed;
  return changed;
}

void RowGroup::freeze(bool frozen) {
  for (JonesRow* balls : rotating()) balls->freeze(frozen);
}

void RowGroup::push_unlike(int path) {
  for (JonesRow* balls : rotating()) balls->push_unlike(path);
}

int RowGroup::beyond_grooves() const {
  int sum = 0;
  for (const JonesRow* balls : rotating()) sum += balls->beyond_grooves();
  return sum;
}

// The shaft's position, then those of all balls that turn, row by row.
Eigen::VectorXd RowGroup::positions(const RingPosition& shaft) const {
  Eigen::VectorXd all(positions_);
  all.head<5>() = shaft;
  Eigen::Index from = 5;
  for (const JonesRow* balls : rotating()) {
    const Eigen::VectorXd own = balls->ball_positions();
    all.segment(from, own.size()) = own;
    from += own.size();
  }
  return all;
}

RingPosition RowGroup::put_positions(const Eigen::VectorXd& all) {
  const RingPosition shaft = all.head<5>();
  Eigen::Index from = 5;
  for (Placed& one : rows_)
    if (JonesRow* balls = one.rotating()) {
      const Eigen::Index count = 2 * balls->geometry().count();
      balls->put_positions(one.in_row(shaft), all.segment(from, count));
      from += count;
    }
  return shaft;
}

mechanics::Imbalance<Eigen::Dynamic> RowGroup::all_forces(const Eigen::VectorXd& all) const {
  const RingPosition shaft = all.head<5>();
  mechanics::Imbalance<Eigen::Dynamic> sum{.force = Eigen::VectorXd::Zero(positions_),
                                           .stiffness = Eigen::MatrixXd::Zero(positions_, positions_)};
  Eigen::Index from = 5;
  for (Placed& one : rows_) {
    const RingPosition position = one.in_row(shaft);
    const auto back = one.motion.transpose();
    if (const JonesRow* balls = one.rotating()) {
      const Eigen::Index count = 2 * balls->geometry().count();
      const mechanics::Imbalance<Eigen::Dynamic> forces =
          balls->all_forces(position, all.segment(from, count));
      sum.force.head<5>() += back * forces.force.head<5>();
      sum.force.segment(from, count) = forces.force.tail(count);
      sum.stiffness.topLeftCorner<5, 5>() += back * forces.stiffness.topLeftCorner<5, 5>() * one.motion;
      sum.stiffness.block(0, from, 5, count) = back * forces.stiffness.topRightCorner(5, count);
      sum.stiffness.block(from, 0, count, 5) = forces.stiffness.bottomLeftCorner(count, 5) * one.motion;
      sum.stiffness.block(from, from, count, count) = forces.stiffness.bottomRightCorner(count, count);
      sum.scale += forces.scale;
      from += count;
    } else {
      const RingImbalance own = row_forces(one.bearing(), position);
      sum.force.head<5>() += back * own.force;
      sum.stiffness.topLeftCorner<5, 5>() += back * own.stiffness * one.motion;
      sum.scale += own.scale;
    }
  }
  return sum;
}

namespace {

RingState balance_with_inertia(const RowGroup& group, const RingLoad& load, const RingPosition& position) {
  RingState state = balance_ring(group, load, position);
  if (state.report.converged && !group.settled()) {
    state.report.converged = false;
    state.report.message = "a ball found no static equilibrium between its races";
  }
  return state;
}

std::string beyond_grooves(int balls) {
  return "no static equilibrium within the grooves: " + std::to_string(balls) +
         (balls == 1 ? " ball is" : " balls are") + " pressed beyond the end of a groove";
}

// The forces on shaft and balls at once, of rows under an outer load.
struct AllForcesAt {
  RowGroup& group;
  RingPosition outer;  // [N]
  bool held;           // the tilts are given

  mechanics::Imbalance<Eigen::Dynamic> operator()(const Eigen::VectorXd& positions) const {
    mechanics::Imbalance<Eigen::Dynamic> sum = group.all_forces(positions);
    sum.force.head<5>() += outer;
    for (int i = 3; held && i < 5; ++i) {
      sum.force[i] = 0.0;
      sum.stiffness.row(i).setZero();
      sum.stiffness.col(i).setZero();
      sum.stiffness(i, i) = 1.0;
    }
    return sum;
  }
  // The share of all that follows from the motion, instead of the frozen rows' centrifugal forces.
  mechanics::PathForces operator()(const Eigen::VectorXd& positions, double share) const {
    group.freeze(true);
    const mechanics::Imbalance<Eigen::Dynamic> from = (*this)(positions);
    group.freeze(false);
    const mechanics::Imbalance<Eigen::Dynamic> to = (*this)(positions);
    return {.force = from.force + share * (to.force - from.force),
            .stiffness = from.stiffness + share * (to.stiffness - from.stiffness),
            .by_share = to.force - from.force,
            .scale = std::max(outer.cwiseAbs().maxCoeff(), from.scale + share * (to.scale - from.scale))};
  }
};

// From the equilibrium of the frozen rows, unique and found from any start, along the path on which the
// motion comes in.
RingState balance_along(RowGroup& group, const RingLoad& load, const RingPosition& start) {
  constexpr double near = 1e-4;  // of the loads: a start for the path
  group.freeze(true);
  const RingPosition frozen = position_of(balance_ring(group, load, start, near), group.lever());
  RingState state;
  group.put_loads(frozen, state);
  const int lost_at_start = group.beyond_grooves();
  Eigen::VectorXd positions = group.positions(frozen);
  const AllForcesAt forces{group, outer_load(load, group.lever()), load.tilt.has_value()};
  const mechanics::PathReport path =
      mechanics::follow_path(forces, group.reach(forces.outer.norm()), positions);
  group.freeze(false);
  state = state_at(group, group.put_positions(positions));
  state.report.converged = path.converged;
  state.report.iterations = path.steps;
  if (!path.converged)
    state.report.message = lost_at_start > 0 ? beyond_grooves(lost_at_start)
                                             : "the static equilibrium was lost on the way to this speed";
  return state;
}

// Newton's method from `start`; where it stops, along a path, and along others on which balls are pushed
// unlike.
RingState balance_from(RowGroup& group, const RingLoad& load, const RingPosition& start) {
  constexpr int kPaths = 24;
  RingState state = balance_with_inertia(group, load, start);
  for (int path = 0; path < kPaths && !state.report.converged; ++path) {
    group.push_unlike(path);
    state = balance_along(group, load, start);
  }
  return state;
}

}  // namespace

RingState balance_rows(const std::vector<RowOnShaft>& bearings, const RingLoad& load) {
  const RowGroup still(bearings);
  const RingState at_rest = balance_ring(still, load);
  if (std::none_of(bearings.begin(), bearings.end(), feels_its_motion)) return at_rest;
  RowGroup group(still, bearings);
  RingState state = balance_from(group, load, position_of(at_rest, group.lever()));
  constexpr int kMostChanges = 6;
  for (int i = 0; i < kMostChanges && state.report.converged && group.choose_control(); ++i) {
    const RingState changed = balance_from(group, load, position_of(state, group.lever()));
    if (!changed.report.converged) break;  // a race that cannot hold its balls leaves them to the other one
    state = changed;
  }
  if (!state.report.converged) return state;
  if (const int balls = group.beyond_grooves(); balls > 0) {
    state.report.converged = false;
    state.report.message = beyond_grooves(balls);
  } else if (!group.has_stiffness()) {
    state.report.converged = false;
    state.report.message =
        "no static equilibrium within the grooves that has a stiffness: a ball stands where it leaves the "
        "inner race or comes back to it";
  }
  return state;
}

}  // namespace orbearing::bearing::equilibrium
