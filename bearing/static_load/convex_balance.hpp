// Balance of a ring on its rolling elements as the least of a convex energy.
//
// Every contact stores an energy that is convex in the displacement of the ring: the approach is a convex
// function of it, and the energy a convex, rising one of the approach. So the balance is one and is found
// from any start: Newton's step with the stiffness cut off from below, and a search along it for the place
// where the unbalanced force has lost its component along the step.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace orbearing::bearing::static_load {

/// Coordinates of a ring are lengths [m]; tilts are taken at a lever.
template <int N>
struct RingForces {
  Eigen::Vector<double, N> force = Eigen::Vector<double, N>::Zero();            // [N]   of the contacts
  Eigen::Matrix<double, N, N> stiffness = Eigen::Matrix<double, N, N>::Zero();  // [N/m] slope of force
  double contact_load = 0.0;  // [N]  of all contacts together, however they cancel
};

/// How the search ended.
struct BalanceReport {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;  // largest unbalanced force over the largest force at hand [-]
  std::string message{};  // empty where converged
};

template <int N>
struct RingBalance {
  Eigen::Vector<double, N> place = Eigen::Vector<double, N>::Zero();  // [m]
  BalanceReport report;
};

/// What is to be balanced.
template <int N>
struct BalanceProblem {
  Eigen::Vector<double, N> load = Eigen::Vector<double, N>::Zero();   // [N]  moments over their lever
  Eigen::Vector<double, N> start = Eigen::Vector<double, N>::Zero();  // [m]  held coordinates keep theirs
  std::array<bool, N> held{};                                         // coordinates that are given
  double reach = 1e-5;                                                // [m]  on which the contacts change
};

namespace detail {

template <int N>
Eigen::Vector<double, N> step_towards(const RingForces<N>& now, const Eigen::Vector<double, N>& unbalanced,
                                      const BalanceProblem<N>& problem) {
  Eigen::Matrix<double, N, N> stiffness = now.stiffness;
  for (int i = 0; i < N; ++i)
    if (problem.held[static_cast<std::size_t>(i)]) {
      stiffness.row(i).setZero();
      stiffness.col(i).setZero();
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> modes(stiffness);
  const double least = std::max(1e-13 * modes.eigenvalues().cwiseAbs().maxCoeff(), 1e-30);
  const Eigen::Vector<double, N> shares = modes.eigenvectors().transpose() * unbalanced;
  const Eigen::Vector<double, N> step =
      modes.eigenvectors() * (shares.array() / modes.eigenvalues().array().max(least)).matrix();
  const double length = step.norm();
  return length > problem.reach ? Eigen::Vector<double, N>(step * (problem.reach / length)) : step;
}

template <int N>
Eigen::Vector<double, N> unbalanced_force(const RingForces<N>& now, const BalanceProblem<N>& problem) {
  Eigen::Vector<double, N> force = problem.load - now.force;
  for (int i = 0; i < N; ++i)
    if (problem.held[static_cast<std::size_t>(i)]) force[i] = 0.0;
  return force;
}

}  // namespace detail

/// `forces_at(place)` gives RingForces<N>: the slope of the contacts' energy, and its slope.
template <int N, typename ForcesAt>
RingBalance<N> balance(const BalanceProblem<N>& problem, const ForcesAt& forces_at) {
  constexpr int most_iterations = 300;
  constexpr int most_halvings = 60;
  constexpr double tolerance = 1e-13;  // of the largest force at hand
  constexpr double acceptable = 1e-9;  // likewise, where round-off stops the search earlier
  RingBalance<N> result{.place = problem.start};
  BalanceReport& report = result.report;
  RingForces<N> now = forces_at(result.place);
  for (; report.iterations < most_iterations; ++report.iterations) {
    const Eigen::Vector<double, N> unbalanced = detail::unbalanced_force(now, problem);
    const double scale = std::max(problem.load.cwiseAbs().maxCoeff(), now.contact_load);
    report.residual = scale > 0.0 ? unbalanced.cwiseAbs().maxCoeff() / scale : 0.0;
    if (report.residual <= tolerance) break;
    const Eigen::Vector<double, N> step = detail::step_towards(now, unbalanced, problem);
    const double slope = unbalanced.dot(step);
    double fraction = 1.0;
    Eigen::Vector<double, N> next = result.place + step;
    RingForces<N> there = forces_at(next);
    for (int i = 0; i < most_halvings; ++i) {
      if (detail::unbalanced_force(there, problem).dot(step) >= -0.7 * slope) break;
      fraction *= 0.5;
      next = result.place + fraction * step;
      there = forces_at(next);
    }
    if ((next - result.place).norm() <= 1e-16 * problem.reach) break;
    result.place = next;
    now = there;
  }
  report.converged = std::isfinite(report.residual) && report.residual <= acceptable;
  if (!report.converged) report.message = "the ring found no balance on its rolling elements";
  return result;
}

}  // namespace orbearing::bearing::static_load
