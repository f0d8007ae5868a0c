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

/// Origin of an equation of the speeds, or of a torque that is not known beforehand.
struct Origin {
  enum class Kind { set, ground, port };  // port: the motor of speeds, the load of torques
  Kind kind = Kind::set;
  std::size_t index = 0;  // of the set, else of the shaft
};

/// matrix * unknowns = right.
struct ArrangementSystem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  std::vector<Origin> origins;  // of its rows for speeds, of its columns for torques
};

/// Weight of a member in Willis' equation, scaled so that the carrier's is -1: z_s/(z_s + z_r), z_r/(z_s +
/// z_r), -1.
double willis_weight(const ArrangedSet& set, Member member);

/// Unknowns: speeds of the shafts over that of the motor. Rows: Willis' equations, grounds, motor.
ArrangementSystem speed_system(const Arrangement& arrangement);
/// Unknowns: what the carrier of each set delivers, whose members' torques are `willis_weight` times it, and
/// the torques of grounds and loads, over the torque of the motor. Rows: shafts.
ArrangementSystem torque_system(const Arrangement& arrangement);

/// The fault, its location, and the requirement. The text names the members and shafts.
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
