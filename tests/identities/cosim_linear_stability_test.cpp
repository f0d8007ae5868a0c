// How long windows of explicit exchange may be: the closed form for a mass whose spring and damper are inputs
// in windows, Eqs. (12) to (14) of coupling/cosim/README.md, and what the scheme does on both sides of it.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "mechanics/linear_algebra.hpp"
#include "tests/linear_halves.hpp"

namespace orbearing::cosim::cosim_linear_stability_test {
namespace {

using linear_halves::LinearPair;
using linear_halves::LinearRun;

LinearPair on_the_wall(double stiffness, double damping) {
  return {.stiffness = 0.0, .joint_stiffness = stiffness, .joint_damping = damping, .behind = 0.0};
}

// (x, x', force one window ago, two ago) from window to window.
Eigen::Matrix4d amplification(const LinearPair& pair, int order, double h) {
  // Shares of the last forces in the mean, and in the first moment, of the force over a window.
  const double mean[3][3] = {{1, 0, 0}, {1.5, -0.5, 0}, {23.0 / 12, -16.0 / 12, 5.0 / 12}};
  const double moment[3][3] = {{0.5, 0, 0}, {2.0 / 3, -1.0 / 6, 0}, {19.0 / 24, -10.0 / 24, 3.0 / 24}};
  const Eigen::RowVector4d now(-pair.joint_stiffness, -pair.joint_damping, 0.0, 0.0);
  Eigen::Matrix4d out = Eigen::Matrix4d::Zero();
  out.row(0) << 1.0, h, 0.0, 0.0;
  out.row(1) << 0.0, 1.0, 0.0, 0.0;
  const auto add = [&](Eigen::Index row, double factor, const double* share) {
    out.row(row) += factor * (share[0] * now + share[1] * Eigen::RowVector4d(0, 0, 1, 0) +
                              share[2] * Eigen::RowVector4d(0, 0, 0, 1));
  };
  add(0, h * h / pair.mass, moment[order]);
  add(1, h / pair.mass, mean[order]);
  out.row(2) = now;
  out(3, 2) = 1.0;
  return out;
}

double growth(const LinearPair& pair, int order, double h) {
  return mechanics::eigenvalues(amplification(pair, order, h)).cwiseAbs().maxCoeff();
}

// The longest window that does not grow.
double limit(const LinearPair& pair, int order) {
  double stable = 1e-3, unstable = 10.0;
  while (unstable - stable > 1e-12) {
    const double middle = 0.5 * (stable + unstable);
    (growth(pair, order, middle) <= 1.0 ? stable : unstable) = middle;
  }
  return stable;
}

TEST(CosimStability, OrderZeroHasTheLimitOfTheDamper) {
  for (const double damping : {0.05, 0.3, 1.0, 1.9, 4.0}) {
    const double expected = std::min(2.0 * damping / 1.0, 2.0 / damping);  // 2 c / k, 2 m / c
    EXPECT_NEAR(limit(on_the_wall(1.0, damping), 0), expected, 1e-9);
  }
}

class CosimStabilityOf : public testing::TestWithParam<int> {};

// The scheme's own growth over many windows, just inside and just outside.
TEST_P(CosimStabilityOf, ExtrapolationIsThatOfTheMatrix) {
  const LinearPair pair = on_the_wall(1.0, 0.3);
  const int order = GetParam();
  const double longest = limit(pair, order);
  for (const double share : {0.9, 1.1}) {
    for (const ExchangeOrder exchange : {ExchangeOrder::jacobi, ExchangeOrder::gauss_seidel}) {
      LinearRun linear(pair, {.order = exchange, .extrapolation = order, .window = share * longest});
      linear.run.advance(100);
      const double before = linear.mass.state().norm();
      const long windows = 200;
      linear.run.advance(windows);
      const double measured =
          std::pow(linear.mass.state().norm() / before, 1.0 / static_cast<double>(windows));
      // The norm swings by the ratio of the axes of the ellipse, some units, whose root is taken.
      EXPECT_NEAR(measured, growth(pair, order, share * longest), 0.01);
      EXPECT_EQ(measured < 1.0, share < 1.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, CosimStabilityOf, testing::Values(0, 1, 2));

}  // namespace
}  // namespace orbearing::cosim::cosim_linear_stability_test
