#include "bearing/race_equilibrium.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/roller_balance.hpp"

namespace orbearing::bearing {

namespace {

constexpr int kMaxIterations = 200;
constexpr int kMaxHalvings = 60;
constexpr double kTolerance = 1e-12;  // of the largest force at hand
constexpr double kAcceptableResidual =
    1e-9;                            // of the largest force, should the iteration end above kTolerance
constexpr double kRoundOff = 1e-15;  // of the lengths whose difference is the approach

Eigen::Vector2d direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

double force_scale(const RaceEquilibrium& problem) {
  return std::max(problem.load.norm(), problem.inertial_load.abs().maxCoeff());
}

// The largest length [m] by which the races stand apart or overlap where they are concentric.
double largest_gap(const RaceEquilibrium& problem) {
  const double extra = problem.extra_approach.size() == 0 ? 0.0 : problem.extra_approach.abs().maxCoeff();
  return std::abs(problem.clearance) + 2.0 * extra;
}

// A first displacement that brings the rollers under the load into contact, of the size that one loaded
// roller asks.
Eigen::Vector2d first_guess(const RaceEquilibrium& problem) {
  const double load = problem.load.norm();
  if (load == 0.0) return Eigen::Vector2d::Zero();
  const double share = 4.0 * load / static_cast<double>(problem.angle.size());
  const double elastic = problem.contacts.inner.approach(share) + problem.contacts.outer.approach(share);
  return problem.load / load * std::max(0.5 * problem.clearance + elastic, 0.0);
}

// The length [m] on which the contacts change: the clearance and the elastic approach under all forces at
// hand, for the rollers' inertial loads alone can outweigh the load on the ring by far.
double contact_reach(const RaceEquilibrium& problem) {
  const double all = problem.load.norm() + problem.inertial_load.abs().sum();
  const LineContact& inner = problem.contacts.inner.elastic();
  const LineContact& outer = problem.contacts.outer.elastic();
  return std::max(largest_gap(problem), 1e-6) + inner.approach(all) + outer.approach(all);
}

// The stiffness is lifted a little so that a ring that is free to roll off a single roller keeps a finite
// step, and the step is kept within the scale on which the contacts change.
Eigen::Vector2d newton_step(const Imbalance& now, double reach) {
  const double lift = 1e-12 * now.stiffness.trace() + 1e-30;
  const Eigen::Matrix2d stiffness = now.stiffness + lift * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d step = stiffness.llt().solve(now.force);
  const double length = step.norm();
  return length > reach ? Eigen::Vector2d(step * (reach / length)) : step;
}

// The forces are the slope of a convex energy, so along the step the force component falls: the largest of
// the halved steps that does not overshoot to more than the force at the start is taken.
double step_fraction(const RaceEquilibrium& problem, const Eigen::Vector2d& from, const Eigen::Vector2d& step,
                     double slope) {
  double fraction = 1.0;
  for (int i = 0; i < kMaxHalvings; ++i, fraction *= 0.5) {
    const double there = problem.imbalance(from + fraction * step).force.dot(step);
    if (there >= -0.7 * slope) return fraction;
  }
  return fraction;
}

// The smallest change of the displacement [m] that the approach can resolve.
double round_off(const RaceEquilibrium& problem, const Eigen::Vector2d& displacement) {
  return kRoundOff * (displacement.norm() + largest_gap(problem));
}

std::string failure_text(const RaceEquilibrium& problem, double residual) {
  std::ostringstream text;
  text << "the races found no balance under " << problem.load.norm() << " N: " << residual
       << " N remain after " << kMaxIterations << " iterations; check the clearance and the roller count";
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

Imbalance RaceEquilibrium::imbalance(const Eigen::Vector2d& displacement) const {
  Imbalance sum;
  sum.force = load;
  for (Eigen::Index j = 0; j < angle.size(); ++j) {
    const Eigen::Vector2d outward = direction(angle[j]);
    const RollerBalance roller =
        balance_roller(contacts.inner, contacts.outer, inertial_load[j], approach(j, displacement));
    sum.force += roller.outer_load * outward;
    sum.stiffness += roller.stiffness * outward * outward.transpose();
  }
  return sum;
}

RollerContacts rolling_contacts(const CylindricalRollerBearing& bearing,
                                const RollerBearingGeometry& geometry, double inner_speed, double outer_speed,
                                const std::optional<Lubricant>& lubricant) {
  const LineContact elastic = roller_race_contact(bearing.contact_law, bearing.roller_length);
  if (!lubricant) return {{elastic, Film()}, {elastic, Film()}};
  const double cage_speed = kinematic_cage_speed(geometry, inner_speed, outer_speed);
  return {{elastic, Film(film_contact(bearing, geometry, Race::inner, *lubricant),
                         std::abs((inner_speed - cage_speed) * geometry.inner_radius))},
          {elastic, Film(film_contact(bearing, geometry, Race::outer, *lubricant),
                         std::abs((outer_speed - cage_speed) * geometry.outer_radius))}};
}

QuasiStaticState solve(const RaceEquilibrium& problem) {
  QuasiStaticState state;
  state.displacement = first_guess(problem);
  const double scale = force_scale(problem);
  const double reach = contact_reach(problem);
  Imbalance now = problem.imbalance(state.displacement);
  for (; state.report.iterations < kMaxIterations; ++state.report.iterations) {
    if (now.force.norm() <= kTolerance * scale) break;
    const Eigen::Vector2d step = newton_step(now, reach);
    if (step.norm() <= round_off(problem, state.displacement)) break;
    state.displacement += step_fraction(problem, state.displacement, step, now.force.dot(step)) * step;
    now = problem.imbalance(state.displacement);
  }
  state.report.residual = now.force.norm();
  const double smallest_step = now.stiffness.trace() * round_off(problem, state.displacement);
  state.report.converged = state.report.residual <= kAcceptableResidual * scale + smallest_step;
  if (!state.report.converged) state.report.message = failure_text(problem, state.report.residual);
  fill_loads(problem, state);
  return state;
}

}  // namespace orbearing::bearing
