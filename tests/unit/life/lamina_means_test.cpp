// Means of the loads' powers, lamina by lamina: aligned rollers, whose halves carry equal loads, are summed
// by one half.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/life/lamina_life.hpp"

namespace orbearing::bearing::life::lamina_means_test {
namespace {

constexpr Eigen::Index kPositions = 11;
constexpr double kRoundOff = 1e-14;

// [N]  symmetric from either end, and none at some of the positions
Eigen::ArrayXXd aligned_loads(Eigen::Index laminae) {
  Eigen::ArrayXXd loads(laminae, kPositions);
  for (Eigen::Index k = 0; k < laminae; ++k)
    for (Eigen::Index position = 0; position < kPositions; ++position) {
      const double outward = std::abs(2.0 * static_cast<double>(k) - static_cast<double>(laminae - 1));
      loads(k, position) = std::fmax(0.0, 40.0 * std::cos(0.6 * static_cast<double>(position)) - outward);
    }
  return loads;
}

double mean_of(const Eigen::ArrayXXd& loads, Eigen::Index lamina, double power) {
  double sum = 0.0;
  for (Eigen::Index position = 0; position < loads.cols(); ++position)
    sum += std::pow(loads(lamina, position), power);
  return sum / static_cast<double>(loads.cols());
}

class LaminaMeansOf : public testing::TestWithParam<Eigen::Index> {
 protected:
  static void expect_plain_means(const Eigen::ArrayXXd& loads) {
    const Eigen::ArrayXXd powers = loads.square().square();
    const LaminaMeans means = lamina_means({RaceMotion::stationary, RaceMotion::rotating}, powers, powers);
    ASSERT_EQ(means.inner.size(), loads.rows());
    for (Eigen::Index k = 0; k < loads.rows(); ++k) {
      EXPECT_NEAR(means.inner[k], mean_of(loads, k, 4.5), kRoundOff * mean_of(loads, k, 4.5)) << k;
      EXPECT_NEAR(means.outer[k], mean_of(loads, k, 4.0), kRoundOff * mean_of(loads, k, 4.0)) << k;
    }
  }
};

TEST_P(LaminaMeansOf, AlignedRollersAreThoseOfEachLamina) {
  expect_plain_means(aligned_loads(GetParam()));
}

TEST_P(LaminaMeansOf, RollersThatLeanAreThoseOfEachLamina) {
  for (Eigen::Index k = 0; k < GetParam(); ++k) {
    Eigen::ArrayXXd loads = aligned_loads(GetParam());
    loads(k, 1) += 3.0;
    expect_plain_means(loads);
  }
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, LaminaMeansOf, testing::Values(1, 2, 5, 6));

}  // namespace
}  // namespace orbearing::bearing::life::lamina_means_test
