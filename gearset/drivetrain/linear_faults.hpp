// Which equations of a linear system contradict each other, and which unknowns it leaves open.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace orbearing::gearset {

/// Whether some x satisfies matrix * x = right. Entries are expected to be of order 1.
bool is_consistent(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Rows that contradict each other and of which none can be left out without the contradiction going away;
/// empty for a consistent system.
std::vector<Eigen::Index> minimal_conflict(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Unknowns that the equations do not fix: those in which some vector of the null space has a part.
std::vector<Eigen::Index> undetermined_unknowns(const Eigen::MatrixXd& matrix);

}  // namespace orbearing::gearset
