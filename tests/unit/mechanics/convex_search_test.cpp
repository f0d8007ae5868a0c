// The one search of all static equilibria.
#include "mechanics/convex_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orbearing::mechanics::convex_search_test {
namespace {

using Vector3 = Eigen::Vector3d;

// A linear spring is in equilibrium after one step: u = K^-1 F.
TEST(ConvexSearch, ALinearSpringTakesOneStep) {
  const Eigen::Matrix2d stiffness = (Eigen::Matrix2d() << 3e6, 1e6, 1e6, 2e6).finished();
  const Eigen::Vector2d load(300.0, -100.0);
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Imbalance<2> now;
  const SearchReport report = find_balance<2>(
      [&](const Eigen::Vector2d& at) {
        return Imbalance<2>{load - stiffness * at, stiffness, load.norm()};
      },
      {.reach = 1.0}, position, now);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_LT((stiffness * position - load).norm(), 1e-12 * load.norm());
}

// One-sided springs k x_+^n on either side of a gap: (F/k)^(1/n) + gap, from far off on either side.
TEST(ConvexSearch, FindsContactFromAnyStart) {
  constexpr double k = 1e10, gap = 1e-5;
  for (const double exponent : {10.0 / 9.0, 1.5})
    for (const double start : {-1e-2, 0.0, 1e-2}) {
      Eigen::Vector<double, 1> position(start);
      Imbalance<1> now;
      const auto contact = [&](const Eigen::Vector<double, 1>& at) {
        const double approach = std::max(0.0, at[0] - gap);
        Imbalance<1> sum;
        sum.force[0] = 100.0 - k * std::pow(approach, exponent);
        sum.stiffness(0, 0) = exponent * k * std::pow(approach, exponent - 1.0);
        sum.scale = 100.0;
        return sum;
      };
      const SearchReport report = find_balance<1>(contact, {.reach = 1e-3, .size = gap}, position, now);
      EXPECT_TRUE(report.converged);
      EXPECT_NEAR(position[0], gap + std::pow(100.0 / k, 1.0 / exponent), 1e-11 * gap);
    }
}

TEST(ConvexSearch, AFreeDirectionStaysWhereNothingPushes) {
  const Eigen::Matrix3d stiffness = Eigen::Vector3d(2e6, 0.0, 5e5).asDiagonal();
  const Vector3 lengths = lengths_under<3>(Vector3(4.0, 0.0, 1.0), stiffness);
  EXPECT_DOUBLE_EQ(lengths[0], 2e-6);
  EXPECT_EQ(lengths[1], 0.0);
  EXPECT_DOUBLE_EQ(lengths[2], 2e-6);
  EXPECT_GT(lengths_under<3>(Vector3(0.0, 1.0, 0.0), stiffness)[1], 1e3 * 5e-7);
}

TEST(ConvexSearch, SaysThatThereIsNoBalance) {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Imbalance<2> now;
  const auto nothing_holds = [](const Eigen::Vector2d&) {
    return Imbalance<2>{Eigen::Vector2d(1.0, 0.0), Eigen::Matrix2d::Zero(), 1.0};
  };
  const SearchReport report = find_balance<2>(nothing_holds, {.reach = 1e-3}, position, now);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.residual, 1.0);
}

TEST(ConvexSearch, NeverConvergesOnNaN) {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Imbalance<2> now;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto broken = [&](const Eigen::Vector2d&) {
    return Imbalance<2>{Eigen::Vector2d(nan, 0.0), Eigen::Matrix2d::Identity(), 1.0};
  };
  EXPECT_FALSE(find_balance<2>(broken, {.reach = 1e-3}, position, now).converged);
}

TEST(ConvexSearch, HeldCoordinatesStay) {
  const Eigen::Matrix2d stiffness = (Eigen::Matrix2d() << 3e6, 1e6, 1e6, 2e6).finished();
  Eigen::Vector2d position(0.0, 2e-5);
  Imbalance<2> now;
  const auto held_spring = [&](const Eigen::Vector2d& at) {
    Imbalance<2> sum{Eigen::Vector2d(100.0, 0.0) - stiffness * at, stiffness, 100.0};
    hold<2>(Eigen::Array<bool, 2, 1>(false, true), sum);
    return sum;
  };
  ASSERT_TRUE(find_balance<2>(held_spring, {.reach = 1.0}, position, now).converged);
  EXPECT_EQ(position[1], 2e-5);
  EXPECT_NEAR(position[0], (100.0 - 1e6 * 2e-5) / 3e6, 1e-15);
}

}  // namespace
}  // namespace orbearing::mechanics::convex_search_test
