// Decompositions of dense matrices that several folders ask for, compiled once: Eigen's templates cost
// seconds in every file that has them.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace orbearing::mechanics {

struct SymmetricModes {
  Eigen::VectorXd values;   // ascending
  Eigen::MatrixXd vectors;  // orthonormal columns
};

/// Eigenvalues and eigenvectors of a symmetric matrix, of which the lower half is read.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a square matrix; with `vectors`, its right eigenvectors as columns of length 1.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix, Eigen::MatrixXcd* vectors = nullptr);

/// The shortest x for which |matrix x - right| is least. Pivots below `threshold` [-] of the largest one
/// count as none; where it is 0, those below round-off do.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right,
                              double threshold = 0.0);

/// matrix^-1 right of a square matrix, with partial pivots; not finite where it is singular.
Eigen::MatrixXd solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// matrix^-1 right of a symmetric, positive definite matrix; none where it is not.
std::optional<Eigen::MatrixXd> definite_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

}  // namespace orbearing::mechanics
