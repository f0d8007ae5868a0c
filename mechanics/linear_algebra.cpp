#include "mechanics/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace orbearing::mechanics {

SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  if (threshold > 0.0) factors.setThreshold(threshold);
  factors.compute(matrix);
  return factors.solve(right);
}

}  // namespace orbearing::mechanics
