// The least of a convex energy: Newton's method, damped along each step. Every static balance in this
// library is such a search.
//
// A contact stores an energy that is convex in the displacement of its bodies: the approach is a convex
// function of it, and the energy a convex, rising one of the approach. So there is one balance, and it is
// found from any start: no step longer than the contacts' own scale, and none that ends where the force that
// drove it points back by more than half.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mechanics/cancellation.hpp"

namespace orbearing::mechanics {

/// Unbalanced forces at one position of N coordinates, and the stiffness there. All coordinates are lengths
/// [m], tilts being multiplied by a lever, so that all forces are in [N]. N may be Eigen::Dynamic.
template <int N>
struct Imbalance {
  // Without coordinates where their number is not known yet.
  Eigen::Vector<double, N> force =
      Eigen::Vector<double, N>::Zero(N == Eigen::Dynamic ? 0 : N);  // [N]  -d(energy)
  Eigen::Matrix<double, N, N> stiffness =
      Eigen::Matrix<double, N, N>::Zero(force.size(), force.size());  // [N/m]  -d(force)
  double scale = 0.0;  // [N]  the largest of the forces in equilibrium
};

struct SearchLimits {
  double reach = 0.0;         // [m]  longest step: the length on which the contacts change
  double size = 0.0;          // [m]  other lengths in the differences that enter the contacts
  double tolerance = 1e-12;   // [-]  of the force that remains, over the scale
  double acceptable = 1e-9;   // [-]  the same, where round-off ends the search before
  double resolution = 1e-15;  // [-]  of the lengths: a shorter step changes nothing
  int most_iterations = 200;
};

/// Result of a search. Without convergence it is the last iterate: check before use.
struct SearchReport {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;  // [N]  force that remains
};

namespace detail {

template <int N>
Eigen::Vector<double, N> lengths_by_pivots(const Eigen::Vector<double, N>& force,
                                           const Eigen::Matrix<double, N, N>& stiffness) {
  constexpr double kFloor = 1e-12, kNothing = 1e-30;
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> factors(stiffness);  // the stiffest freedom first
  const auto pivots = factors.vectorD().array();
  const double least = std::max(kFloor * pivots.abs().maxCoeff(), kNothing);
  Eigen::Vector<double, N> lengths = factors.transpositionsP() * force;
  factors.matrixL().solveInPlace(lengths);
  lengths.array() /= pivots.max(least);
  factors.matrixU().solveInPlace(lengths);
  return factors.transpositionsP().transpose() * lengths;
}

}  // namespace detail

/// Lengths [m] that `force` causes on a stiffness that may be singular. A direction with next to no stiffness
/// is given 1e-12 of the stiffest one's: forces along it ask for far too long a step, and no force for none.
template <int N>
Eigen::Vector<double, N> lengths_under(const Eigen::Vector<double, N>& force,
                                       const Eigen::Matrix<double, N, N>& stiffness) {
  return detail::lengths_by_pivots<N>(force, stiffness);
}

/// Compiled once (linear_algebra.cpp).
template <>
Eigen::VectorXd lengths_under<Eigen::Dynamic>(const Eigen::VectorXd& force, const Eigen::MatrixXd& stiffness);

namespace detail {

template <int N>
Eigen::Vector<double, N> within(double reach, const Eigen::Vector<double, N>& step) {
  const double length = step.norm();
  return length > reach ? Eigen::Vector<double, N>(step * (reach / length)) : step;
}

}  // namespace detail

/// Whether the residual force at `position` is below the limit, or below the resolution of lengths.
template <int N>
bool is_balanced(const Imbalance<N>& now, const Eigen::Vector<double, N>& position,
                 const SearchLimits& limits) {
  const double round_off = limits.resolution * (position.norm() + limits.size);
  return now.force.norm() <= limits.acceptable * now.scale + now.stiffness.trace() * round_off;
}

namespace detail {

// The search of all equilibria. `lengths(force, stiffness)` are those that the force causes.
template <int N, class Function, class Lengths>
SearchReport damped_search(Function&& imbalance_at, const Lengths& lengths, const SearchLimits& limits,
                           Eigen::Vector<double, N>& position, Imbalance<N>& now) {
  constexpr int kMostShortenings = 60;
  constexpr double kOvershoot = 0.5;  // of the driving force, that may point back after a step
  SearchReport report;
  now = imbalance_at(position);
  for (; report.iterations < limits.most_iterations; ++report.iterations) {
    throw_if_stopped();
    if (!(now.force.norm() > limits.tolerance * now.scale)) break;
    const Eigen::Vector<double, N> step = within<N>(limits.reach, lengths(now.force, now.stiffness));
    if (step.norm() <= limits.resolution * (position.norm() + limits.size)) break;
    const Eigen::Vector<double, N> from = position;
    const double drive = now.force.dot(step);
    double fraction = 1.0;
    for (int i = 0; i < kMostShortenings; ++i) {
      position = from + fraction * step;
      now = imbalance_at(position);
      const double left = now.force.dot(step);
      if (left >= -kOvershoot * drive) break;
      fraction *= std::max(0.1, drive / (drive - left));  // where the secant puts its zero
    }
  }
  report.residual = now.force.norm();
  report.converged = is_balanced<N>(now, position, limits);
  return report;
}

}  // namespace detail

/// Follows `imbalance_at(position)`, an Imbalance<N>, to where the force vanishes. `position` holds the start
/// and then the equilibrium, `now` the imbalance there. Throws Cancelled.
template <int N, class Function>
SearchReport find_balance(Function&& imbalance_at, const SearchLimits& limits,
                          Eigen::Vector<double, N>& position, Imbalance<N>& now) {
  return detail::damped_search<N>(std::forward<Function>(imbalance_at), lengths_under<N>, limits, position,
                                  now);
}

/// Takes the freedoms out of a search whose coordinates are given: they bear any force.
template <int N>
void hold(const Eigen::Array<bool, N, 1>& held, Imbalance<N>& imbalance) {
  for (int i = 0; i < N; ++i) {
    if (!held[i]) continue;
    imbalance.force[i] = 0.0;
    imbalance.stiffness.row(i).setZero();
    imbalance.stiffness.col(i).setZero();
  }
}

}  // namespace orbearing::mechanics
