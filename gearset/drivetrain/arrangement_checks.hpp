// Whether an arrangement of sets fixes all speeds and torques, and which members are at fault where it does
// not.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset {

// The linear equations of an arrangement, each row and column with a name, so that a fault can be stated in
// the user's words. Eqs. (26) to (29) of gearset/README.md.

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

// Which equations of a linear system contradict each other, and which unknowns it leaves open.

/// Whether some x satisfies matrix * x = right. Entries are expected to be of order 1.
bool is_consistent(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Rows that contradict each other and of which none can be left out without the contradiction going away;
/// empty for a consistent system.
std::vector<Eigen::Index> minimal_conflict(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Unknowns that the equations do not fix: those in which some vector of the null space has a part.
std::vector<Eigen::Index> undetermined_unknowns(const Eigen::MatrixXd& matrix);

/// What is wrong, where, and what is required. The text names the members and shafts.
struct ArrangementProblem {
  std::vector<std::size_t> shafts;  // concerned, the likeliest culprit first; empty: none to name
  std::vector<SetMember> members;   // at fault
  std::string found;
  std::string required;
};

/// Reasons why speeds or torques contradict each other or stay open; empty for a sound arrangement. A
/// contradiction names the smallest group of members that holds it, an open quantity those that can change
/// without breaking an equation.
std::vector<ArrangementProblem> arrangement_problems(const Arrangement& arrangement);

}  // namespace orbearing::gearset
