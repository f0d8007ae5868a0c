// Whether an arrangement of sets fixes all speeds and torques, and which members are at fault where it does
// not.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset {

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
