// Root of a system of forces without a potential: the damped Newton search of convex_search.hpp for
// stiffnesses that need not be symmetric. Examples: forces that follow the motion, such as friction and
// gyroscopic moments.
//
// Its steps, their bound and the rule by which one is shortened are those of the convex search. A stiffness
// whose forces do not resist the step is replaced by its symmetric part: with that a step always goes along
// the force.
#pragma once

#include <Eigen/LU>

#include "mechanics/convex_search.hpp"

namespace orbearing::mechanics {

/// Lengths [m] that `force` causes on a stiffness that need be neither symmetric nor regular.
template <int N>
Eigen::Vector<double, N> lengths_under_any(const Eigen::Vector<double, N>& force,
                                           const Eigen::Matrix<double, N, N>& stiffness) {
  constexpr double kFloor = 1e-12, kNothing = 1e-30;
  using Square = Eigen::Matrix<double, N, N>;
  const double floor = std::max(kFloor * stiffness.diagonal().cwiseAbs().maxCoeff(), kNothing);
  const Square firm = stiffness + floor * Square::Identity();
  Eigen::Vector<double, N> lengths;
  if constexpr (N == 2) {  // by hand, a fifth of the time
    const double inverse = 1.0 / (firm(0, 0) * firm(1, 1) - firm(0, 1) * firm(1, 0));
    lengths[0] = inverse * (firm(1, 1) * force[0] - firm(0, 1) * force[1]);
    lengths[1] = inverse * (firm(0, 0) * force[1] - firm(1, 0) * force[0]);
  } else {
    lengths = firm.partialPivLu().solve(force);
  }
  if (lengths.allFinite() && force.dot(lengths) > 0.0) return lengths;
  return lengths_under<N>(force, 0.5 * (stiffness + stiffness.transpose()));
}

/// Follows `imbalance_at(position)`, an Imbalance<N>, to where the force vanishes; `position` and `now` as
/// for find_balance.
template <int N, class Function>
SearchReport find_root(Function&& imbalance_at, const SearchLimits& limits,
                       Eigen::Vector<double, N>& position, Imbalance<N>& now) {
  return detail::damped_search<N>(std::forward<Function>(imbalance_at), lengths_under_any<N>, limits,
                                  position, now);
}

}  // namespace orbearing::mechanics
