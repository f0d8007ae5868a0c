#include "mechanics/dense_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace orbearing::mechanics::dense_lu_test {
namespace {

constexpr double kRoundOff = 1e-13;  // of 20 rows near a diagonal of ones

DenseLu::Matrix near_the_diagonal(Eigen::Index rows) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> small(-0.02, 0.02);
  DenseLu::Matrix matrix = DenseLu::Matrix::Identity(rows, rows);
  for (double& entry : matrix.reshaped()) entry += small(random);
  return matrix;
}

TEST(DenseLu, SolvesAsEigenDoes) {
  const DenseLu::Matrix matrix = near_the_diagonal(20);
  const Eigen::VectorXd rhs = Eigen::VectorXd::LinSpaced(20, -1.0, 3.0);
  DenseLu factors;
  ASSERT_TRUE(factors.factor(matrix));
  Eigen::VectorXd solution = rhs;
  factors.solve(solution);
  EXPECT_LT((matrix * solution - rhs).norm(), kRoundOff);
  EXPECT_LT((solution - matrix.partialPivLu().solve(rhs)).norm(), kRoundOff);
}

TEST(DenseLu, SaysWhereAPivotVanishes) {
  DenseLu::Matrix matrix = DenseLu::Matrix::Identity(3, 3);
  matrix(1, 1) = 0.0;
  EXPECT_FALSE(DenseLu().factor(matrix));
}

}  // namespace
}  // namespace orbearing::mechanics::dense_lu_test
