#include "bearing/equilibrium/ring_balance.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/force_left.hpp"
#include "mechanics/root_search.hpp"

namespace orbearing::bearing::equilibrium {

RingImbalance row_forces(const RingRow& row, const RingPosition& position) {
  RingImbalance sum;
  row.add_forces(position, sum);
  return sum;
}

RingPosition outer_load(const RingLoad& load, double lever) {
  const bool held = load.tilt.has_value();
  return (RingPosition() << load.radial, 0.0, load.axial, held ? 0.0 : load.moment / lever,
          held ? 0.0 : load.moment_across / lever)
      .finished();
}

Eigen::Matrix<double, 5, 5> by_tilt(const Eigen::Matrix<double, 5, 5>& stiffness, double lever) {
  const Eigen::Vector<double, 5> arms(1.0, 1.0, 1.0, lever, lever);
  return arms.asDiagonal() * stiffness * arms.asDiagonal();
}

RingState state_at(const RingRow& row, const RingPosition& position) {
  const double lever = row.lever();
  const RingImbalance borne = row_forces(row, position);
  RingState state;
  state.radial = position[0];
  state.lateral = position[1];
  state.axial = position[2];
  state.tilt = std::atan(position[3] / lever);
  state.lateral_tilt = std::atan(position[4] / lever);
  state.moment = -borne.force[3] * lever;
  state.lateral_moment = -borne.force[4] * lever;
  state.stiffness = by_tilt(borne.stiffness, lever);
  row.put_loads(position, state);
  return state;
}

RingState balance_ring(const RingRow& row, const RingLoad& load, const RingPosition& start, double near) {
  const double lever = row.lever();
  const bool tilt_given = load.tilt.has_value();
  const RingPosition outer = outer_load(load, lever);
  const Eigen::Array<bool, 5, 1> held(false, false, false, tilt_given, tilt_given);
  RingPosition position = start;
  if (tilt_given) {
    position[3] = lever * std::tan(*load.tilt);
    position[4] = 0.0;
  }
  const double reach = row.reach(outer.norm()) + std::abs(position[3]);
  const auto imbalance_at = [&](const RingPosition& at) {
    RingImbalance sum = row_forces(row, at);
    sum.force += outer;
    sum.scale = std::max(sum.scale, outer.cwiseAbs().maxCoeff());
    mechanics::hold<5>(held, sum);
    return sum;
  };
  RingImbalance now;
  BalanceReport report;
  mechanics::SearchLimits limits{.reach = reach, .tolerance = 1e-13, .most_iterations = 300};
  if (near > 0.0) limits.tolerance = limits.acceptable = near;
  if (row.follows_motion()) {
    limits.most_iterations = 60;  // begins near its end, or not at all
    report = {mechanics::find_root<5>(imbalance_at, limits, position, now)};
  } else {
    report = {mechanics::find_balance<5>(imbalance_at, limits, position, now)};
  }
  report.residual = mechanics::force_left(report.residual);
  if (!report.converged) report.message = "the ring found no static equilibrium on its rolling elements";
  RingState state = state_at(row, position);
  state.report = report;
  return state;
}

}  // namespace orbearing::bearing::equilibrium
