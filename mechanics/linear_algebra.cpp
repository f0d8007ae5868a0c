#include "mechanics/linear_algebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "mechanics/convex_search.hpp"

namespace orbearing::mechanics {

SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix, Eigen::MatrixXcd* vectors) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, vectors != nullptr);
  if (vectors != nullptr) *vectors = solver.eigenvectors();
  return solver.eigenvalues();
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  if (threshold > 0.0) factors.setThreshold(threshold);
  factors.compute(matrix);
  return factors.solve(right);
}

Eigen::MatrixXd solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

std::optional<Eigen::MatrixXd> definite_solution(const Eigen::MatrixXd& matrix,
                                                 const Eigen::MatrixXd& right) {
  const Eigen::LLT<Eigen::MatrixXd> factors(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  return factors.solve(right);
}

template <>
Eigen::VectorXd lengths_under<Eigen::Dynamic>(const Eigen::VectorXd& force,
                                              const Eigen::MatrixXd& stiffness) {
  return detail::lengths_by_pivots<Eigen::Dynamic>(force, stiffness);
}

}  // namespace orbearing::mechanics
