// The balance of the outer ring on its rollers: two force equations for the displacement of the races.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/geometry.hpp"
#include "bearing/quasi_static_state.hpp"
#include "bearing/race_contact.hpp"

namespace orbearing::bearing {

/// Force on the outer ring out of balance, and its stiffness.
struct Imbalance {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();      // [N]
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]  -d(force)/d(displacement)
};

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
  Imbalance imbalance(const Eigen::Vector2d& displacement) const;
};

/// Contacts of a roller at pure rolling, with the film of `lubricant` in the approach where one is given.
RollerContacts rolling_contacts(const CylindricalRollerBearing& bearing,
                                const RollerBearingGeometry& geometry, double inner_speed, double outer_speed,
                                const std::optional<Lubricant>& lubricant);

/// Displacement at which the forces on the outer ring balance.
QuasiStaticState solve(const RaceEquilibrium& problem);

}  // namespace orbearing::bearing
