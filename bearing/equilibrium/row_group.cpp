#include "bearing/equilibrium/row_group.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

double lever_of_row(const std::variant<BallRow, RollerRow, MovingBallRow>& row) {
  return std::visit([](const auto& one) { return one.lever(); }, row);
}

// A group whose forces have no energy.
struct TurningGroup {
  static constexpr bool follows_motion = true;
  const RowGroup& group;

  double lever() const { return group.lever(); }
  double reach(double load) const { return group.reach(load); }
  void add_forces(const RingPlace& place, RingImbalance& sum) const { group.add_forces(place, sum); }
  void put_loads(const RingPlace& place, RingState& state) const { group.put_loads(place, state); }
};

void append(const Eigen::ArrayXd& more, Eigen::ArrayXd& all) {
  Eigen::ArrayXd joined(all.size() + more.size());
  joined << all, more;
  all = joined;
}

}  // namespace

RowGroup::RowGroup(const std::vector<RowOnShaft>& bearings, bool turning) {
  mechanics::require(!bearings.empty(), "rows", 0.0, "at least one");
  for (const RowOnShaft& one : bearings) {
    mechanics::require(std::abs(one.side) == 1.0, "side of a row", one.side, "+1 or -1");
    if (one.bearing.has_rollers())
      rows_.push_back({RollerRow(one.bearing), {}, 0.0});
    else if (turning && !one.motion.speeds.at_rest() && (one.motion.inertia.enabled || one.motion.film))
      rows_.push_back({MovingBallRow(one.bearing, one.motion), {}, one.approach});
    else
      rows_.push_back({BallRow(one.bearing), {}, one.approach});
    lever_ = std::max(lever_, lever_of_row(rows_.back().row));
  }
  for (std::size_t k = 0; k < rows_.size(); ++k)
    rows_[k].motion =
        motion_of_row(bearings[k].position, bearings[k].side, lever_, lever_of_row(rows_[k].row));
}

RingPlace RowGroup::Placed::in_row(const RingPlace& place) const {
  RingPlace own = motion * place;
  own[2] += approach;
  return own;
}

double RowGroup::reach(double load) const {
  double longest = 0.0;
  for (const Placed& one : rows_)
    longest = std::max(longest, std::abs(one.approach) +
                                    std::visit([&](const auto& row) { return row.reach(load); }, one.row));
  return longest;
}

void RowGroup::add_forces(const RingPlace& place, RingImbalance& sum) const {
  for (Placed& one : rows_) {
    RingImbalance own;
    std::visit([&](auto& row) { row.add_forces(one.in_row(place), own); }, one.row);
    sum.force += one.motion.transpose() * own.force;
    sum.stiffness += one.motion.transpose() * own.stiffness * one.motion;
    sum.scale += own.scale;
  }
}

void RowGroup::put_loads(const RingPlace& place, RingState& state) const {
  for (Placed& one : rows_) {
    RingState own;
    std::visit([&](auto& row) { row.put_loads(one.in_row(place), own); }, one.row);
    append(own.contact_load, state.contact_load);
    append(own.contact_angle, state.contact_angle);
    append(own.outer_load, state.outer_load);
    append(own.outer_angle, state.outer_angle);
    append(own.inner_rolling, state.inner_rolling);
    append(own.inner_spin, state.inner_spin);
    append(own.outer_rolling, state.outer_rolling);
    append(own.outer_spin, state.outer_spin);
    state.friction = std::max(state.friction, own.friction);
    state.largest_pressure = std::max(state.largest_pressure, own.largest_pressure);
  }
}

bool RowGroup::turns() const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [](const Placed& one) { return std::holds_alternative<MovingBallRow>(one.row); });
}

bool RowGroup::settled() const {
  return std::all_of(rows_.begin(), rows_.end(), [](const Placed& one) {
    const auto* balls = std::get_if<MovingBallRow>(&one.row);
    return !balls || balls->settled();
  });
}

RingState balance_rows(const std::vector<RowOnShaft>& bearings, const RingLoad& load) {
  const RowGroup still(bearings, false), group(bearings, true);
  const RingState at_rest = balance_ring(still, load);
  if (!group.turns()) return at_rest;
  RingState state = balance_ring(TurningGroup{group}, load, place_of(at_rest, group.lever()));
  if (state.report.converged && !group.settled()) {
    state.report.converged = false;
    state.report.message = "a ball found no balance between its races";
  }
  return state;
}

}  // namespace orbearing::bearing::equilibrium
