#include "gearset/drivetrain/linear_faults.hpp"

#include <Eigen/LU>

namespace orbearing::gearset {

namespace {

// Weights are ratios of teeth. A pivot that is not zero is then a fraction over a product of sums of teeth,
// above 1e-9 for four sets of 150 teeth even if it is the least possible one; a pivot that is zero is
// round-off.
constexpr double rank_tolerance = 1e-10;

Eigen::FullPivLU<Eigen::MatrixXd> ranked(const Eigen::MatrixXd& matrix) {
  Eigen::FullPivLU<Eigen::MatrixXd> decomposition(matrix);
  decomposition.setThreshold(rank_tolerance);
  return decomposition;
}

Eigen::Index rank_of(const Eigen::MatrixXd& matrix) {
  return matrix.size() == 0 ? 0 : ranked(matrix).rank();
}

Eigen::MatrixXd with_column(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& column) {
  Eigen::MatrixXd joined(matrix.rows(), matrix.cols() + 1);
  joined << matrix, column;
  return joined;
}

std::vector<Eigen::Index> without(const std::vector<Eigen::Index>& rows, std::size_t position) {
  std::vector<Eigen::Index> fewer;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i != position) fewer.push_back(rows[i]);
  return fewer;
}

}  // namespace

bool is_consistent(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return rank_of(with_column(matrix, right)) == rank_of(matrix);
}

// Deletion filter: a row without which the contradiction stays is not needed for it.
std::vector<Eigen::Index> minimal_conflict(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  if (is_consistent(matrix, right)) return {};
  std::vector<Eigen::Index> kept;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) kept.push_back(row);
  for (std::size_t position = 0; position < kept.size();) {
    const std::vector<Eigen::Index> fewer = without(kept, position);
    if (is_consistent(matrix(fewer, Eigen::all), right(fewer)))
      ++position;
    else
      kept = fewer;
  }
  return kept;
}

std::vector<Eigen::Index> undetermined_unknowns(const Eigen::MatrixXd& matrix) {
  const auto decomposition = ranked(matrix);
  if (decomposition.rank() == matrix.cols()) return {};
  const Eigen::MatrixXd null_space = decomposition.kernel();
  std::vector<Eigen::Index> unknowns;
  for (Eigen::Index i = 0; i < matrix.cols(); ++i)
    if (null_space.row(i).norm() > rank_tolerance) unknowns.push_back(i);
  return unknowns;
}

}  // namespace orbearing::gearset
