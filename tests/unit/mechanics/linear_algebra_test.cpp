#include "mechanics/linear_algebra.hpp"

#include <gtest/gtest.h>

namespace orbearing::mechanics::linear_algebra_test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

TEST(SymmetricModes, AscendAndGiveTheMatrixBack) {
  MatrixXd matrix(3, 3);
  matrix << 4.0, 1.0, -2.0, 1.0, 3.0, 0.5, -2.0, 0.5, 1.0;
  const SymmetricModes modes = symmetric_modes(matrix);
  EXPECT_LT(modes.values[0], modes.values[1]);
  EXPECT_LT(modes.values[1], modes.values[2]);
  EXPECT_LT((modes.vectors * modes.values.asDiagonal() * modes.vectors.transpose() - matrix).norm(), 1e-14);
  EXPECT_LT((modes.vectors.transpose() * modes.vectors - Matrix3d::Identity()).norm(), 1e-14);
}

// Two unknowns that show as their sum alone, in three rows that contradict each other: the shortest of the best.
TEST(LeastSquares, TakesTheShortestOfThoseThatFitBest) {
  MatrixXd matrix(3, 2), right(3, 1);
  matrix << 1.0, 1.0, 1.0, 1.0, 1.0, 1.0;
  right << 1.0, 2.0, 6.0;
  EXPECT_LT((least_squares(matrix, right) - Eigen::Vector2d(1.5, 1.5)).norm(), 1e-14);
}

TEST(LeastSquares, LeavesOutPivotsBelowTheThreshold) {
  const MatrixXd matrix = Vector3d(1.0, 0.5, 1e-11).asDiagonal();
  const MatrixXd right = Vector3d(1.0, 1.0, 1.0);
  EXPECT_LT((least_squares(matrix, right, 1e-10) - Vector3d(1.0, 2.0, 0.0)).norm(), 1e-14);
  EXPECT_NEAR(least_squares(matrix, right)(2), 1e11, 1.0);
}

}  // namespace
}  // namespace orbearing::mechanics::linear_algebra_test
