// The linear equations of an arrangement, each row and column with a name, so that a fault can be stated in
// the user's words. Eqs. (26) to (29) of gearset/README.md.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset {

/// A condition that the speeds must meet.
struct SpeedCondition {
  enum class Kind { willis, ground, motor };
  Kind kind = Kind::willis;
  std::size_t index = 0;  // of the set for willis, else of the shaft
};

/// matrix * (speeds of shafts / speed of the motor) = right.
struct SpeedSystem {
  Eigen::MatrixXd matrix;  // (conditions, shafts)
  Eigen::VectorXd right;   // (conditions)
  std::vector<SpeedCondition> conditions;
};

/// A torque that is not known beforehand.
struct TorqueUnknown {
  enum class Kind { set, ground, load };
  Kind kind = Kind::set;
  std::size_t index = 0;  // of the set, else of the shaft
};

/// matrix * (torques / torque of the motor) = right. A set's unknown is what its carrier delivers; its
/// members' torques are `willis_weight` times it.
struct TorqueSystem {
  Eigen::MatrixXd matrix;  // (shafts, unknowns)
  Eigen::VectorXd right;   // (shafts)
  std::vector<TorqueUnknown> unknowns;
};

/// Weight of a member in Willis' equation, scaled so that the carrier's is -1: z_s/(z_s + z_r), z_r/(z_s +
/// z_r), -1.
double willis_weight(const ArrangedSet& set, Member member);

SpeedSystem speed_system(const Arrangement& arrangement);
TorqueSystem torque_system(const Arrangement& arrangement);

}  // namespace orbearing::gearset
