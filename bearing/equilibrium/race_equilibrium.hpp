// The balance of the outer ring on its rollers: two force equations for the displacement of the races.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/contact/race_contact.hpp"
#include "bearing/equilibrium/quasi_static_state.hpp"
#include "bearing/geometry.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

/// What the races must balance at one cage angle. Arrays are over rollers.
struct RaceEquilibrium {
  RollerContacts contacts;
  double clearance = 0.0;                          // [m]    diametral
  Eigen::Vector2d load = Eigen::Vector2d::Zero();  // [N]  on the outer ring
  Eigen::ArrayXd angle = {};                       // [rad]
  Eigen::ArrayXd inertial_load = {};               // [N]    of each roller, outward positive
  Eigen::ArrayXd extra_approach = {};  // [m]    by unequal rollers and races that are not round; empty: none

  /// Approach of the races at roller `j` [m] when the outer ring is displaced by `displacement` [m].
  double approach(Eigen::Index j, const Eigen::Vector2d& displacement) const;
  /// Forces on the outer ring at `displacement` [m].
  mechanics::Imbalance<2> imbalance(const Eigen::Vector2d& displacement) const;
};

/// Where a search for the displacement of the races begins, and how far it may go: the rollers under the load
/// in contact, as far as one loaded roller asks.
Eigen::Vector2d first_displacement(const RaceEquilibrium& problem);
mechanics::SearchLimits search_limits(const RaceEquilibrium& problem);

/// Displacement at which the forces on the outer ring balance.
QuasiStaticState solve(const RaceEquilibrium& problem);

}  // namespace orbearing::bearing
