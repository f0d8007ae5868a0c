#include "bearing/equilibrium/race_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/equilibrium/roller_balance.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing {

namespace {

double force_scale(const RaceEquilibrium& problem) {
  return std::max(problem.load.norm(), problem.inertial_load.abs().maxCoeff());
}

// The largest length [m] by which the races stand apart or overlap where they are concentric.
double largest_gap(const RaceEquilibrium& problem) {
  const double extra = problem.extra_approach.size() == 0 ? 0.0 : problem.extra_approach.abs().maxCoeff();
  return std::abs(problem.clearance) + 2.0 * extra;
}

std::string failure_text(const RaceEquilibrium& problem, double residual) {
  std::ostringstream text;
  text << "the races found no balance under " << problem.load.norm() << " N: " << residual
       << " N remain; check the clearance and the roller count";
  return text.str();
}

void fill_loads(const RaceEquilibrium& problem, QuasiStaticState& state) {
  state.angle = problem.angle;
  state.inner_load.resize(problem.angle.size());
  state.outer_load.resize(problem.angle.size());
  for (Eigen::Index j = 0; j < problem.angle.size(); ++j) {
    const RollerBalance roller =
        balance_roller(problem.contacts.inner, problem.contacts.outer, problem.inertial_load[j],
                       problem.approach(j, state.displacement));
    state.inner_load[j] = roller.inner_load;
    state.outer_load[j] = roller.outer_load;
  }
}

}  // namespace

double RaceEquilibrium::approach(Eigen::Index j, const Eigen::Vector2d& displacement) const {
  const double round = -0.5 * clearance - displacement.dot(direction(angle[j]));
  return extra_approach.size() == 0 ? round : round + extra_approach[j];
}

mechanics::Imbalance<2> RaceEquilibrium::imbalance(const Eigen::Vector2d& displacement) const {
  mechanics::Imbalance<2> sum;
  sum.force = load;
  sum.scale = force_scale(*this);
  for (Eigen::Index j = 0; j < angle.size(); ++j) {
    const Eigen::Vector2d outward = direction(angle[j]);
    const RollerBalance roller =
        balance_roller(contacts.inner, contacts.outer, inertial_load[j], approach(j, displacement));
    sum.force += roller.outer_load * outward;
    sum.stiffness += roller.stiffness * outward * outward.transpose();
  }
  return sum;
}

Eigen::Vector2d first_displacement(const RaceEquilibrium& problem) {
  const double load = problem.load.norm();
  if (load == 0.0) return Eigen::Vector2d::Zero();
  const double share = 4.0 * load / static_cast<double>(problem.angle.size());
  const double elastic = problem.contacts.inner.approach(share) + problem.contacts.outer.approach(share);
  return problem.load / load * std::max(0.5 * problem.clearance + elastic, 0.0);
}

// The contacts change over the clearance and the elastic approach under all forces at hand, for the rollers'
// inertial loads alone can outweigh the load on the ring by far.
mechanics::SearchLimits search_limits(const RaceEquilibrium& problem) {
  const double all = problem.load.norm() + problem.inertial_load.abs().sum();
  const double elastic =
      problem.contacts.inner.elastic().approach(all) + problem.contacts.outer.elastic().approach(all);
  const double gap = largest_gap(problem);
  return {.reach = std::max(gap, 1e-6) + elastic, .size = gap};
}

QuasiStaticState solve(const RaceEquilibrium& problem) {
  QuasiStaticState state;
  state.displacement = first_displacement(problem);
  mechanics::Imbalance<2> now;
  state.report = {mechanics::find_balance<2>(
      [&](const Eigen::Vector2d& displacement) { return problem.imbalance(displacement); },
      search_limits(problem), state.displacement, now)};
  if (!state.report.converged) state.report.message = failure_text(problem, state.report.residual);
  fill_loads(problem, state);
  return state;
}

}  // namespace orbearing::bearing
