// How the loads of the elements of a bearing under a static load follow any number that goes into its
// balance: forward differentiation through the contact laws, and the implicit function theorem for the ring.
// Eq. (21) of README.md, of balls that feel their motion Eq. (22).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/equilibrium/static_bearing.hpp"

namespace orbearing::bearing::equilibrium {

/// Slopes of the loads of all elements.
struct ElementSlopes {
  Eigen::ArrayXd contact;   // [N per unit]  (elements)  on the inner race
  Eigen::ArrayXd outer;     // [N per unit]  (balls)  on the outer one, where it differs; else empty
  Eigen::ArrayXXd laminae;  // [N per unit]  (laminae, rollers); of balls none
};

/// A balance with all that does not depend on what is changed.
class StaticSlopes {
 public:
  /// @param state the balance of `bearing` under `load`
  StaticSlopes(const Bearing& bearing, const RingLoad& load, const RingState& state);

  /// All numbers behind the loads with the ring where it stands in this balance; a tilt that is given follows
  /// the load. Of bearings of one shape alone: the same kind and count of elements and laminae.
  Eigen::VectorXd numbers(const Bearing& bearing, const RingLoad& load) const;

  /// As the numbers change by `change` a unit.
  ElementSlopes along(const Eigen::Ref<const Eigen::VectorXd>& change) const;

 private:
  bool held_ = false;  // the tilts are given
  Eigen::Index count_ = 0;
  RingPlace place_;
  Eigen::VectorXd numbers_;
  Eigen::ArrayXd station_;                 // [-]  (laminae)  fractions of half the length; of balls none
  Eigen::Matrix<double, 5, 5> stiffness_;  // [N/m]  of the ring
};

/// The same of a row of balls that feel their motion.
class MovingBallSlopes {
 public:
  /// @param state the balance of `bearing`, whose balls feel `motion`, under `load`
  MovingBallSlopes(const Bearing& bearing, const RowMotion& motion, const RingLoad& load,
                   const RingState& state);

  /// As StaticSlopes::numbers(): constants of the laws, load, and the groove centres of all balls with the
  /// ring where it stands.
  Eigen::VectorXd numbers(const Bearing& bearing, const RowMotion& motion, const RingLoad& load) const;

  /// As the numbers change by `change` a unit. Balls stay under the race that controls their spin.
  ElementSlopes along(const Eigen::Ref<const Eigen::VectorXd>& change) const;

 private:
  struct Ball;
  Ball ball_along(const Eigen::Ref<const Eigen::VectorXd>& change, Eigen::Index j) const;

  bool held_ = false;  // the tilts are given
  Eigen::Index count_ = 0;
  RingPlace place_;
  Eigen::Array2Xd ball_place_;  // [m]  from the outer groove centre
  std::vector<bool> inner_control_;
  BallLaw<double> law_;
  Eigen::VectorXd numbers_;
  Eigen::Matrix<double, 5, 5> stiffness_;  // [N/m]  of the ring, with the balls in balance
};

}  // namespace orbearing::bearing::equilibrium
