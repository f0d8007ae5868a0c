#include "bearing/pressure/strip_influence.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "mechanics/constants.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::bearing::half_space::strip_influence_test {
namespace {

using constants::half_pi;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kRoundOff = 1e-12;
constexpr double kTable = 1e-7;  // error of the kernel's table over the second difference of a short element
constexpr double kDifference = 1e-6;  // central difference with a step of 1e-3 of the width

const double kLength = 6e-3;

LengthGrid grid() {
  return graded_grid(kLength, 24);
}

ArrayXd widths(const LengthGrid& positions) {
  return 60e-6 * (1.0 + 0.3 * (2.0 * positions.middle / kLength).square());
}

MatrixXd influence(double mirror_factor, double scale = 1.0) {
  StripMatrices matrices;
  StripInfluence(grid(), mirror_factor).evaluate(scale * widths(grid()), matrices);
  return matrices.influence;
}

/// Integral over both elements of the mean of 1/r over two semi-ellipses of half width b, places far enough
/// apart.
double by_quadrature(const LengthGrid& positions, Index i, Index j, double b) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const auto between = [&](double x) {
    return Rule::integrate(
        [&](double t) {
          return Rule::integrate(
              [&](double u) {
                const double root = std::sin(half_pi * t) - std::sin(half_pi * u);
                const double weight = std::pow(std::cos(half_pi * t) * std::cos(half_pi * u), 2);
                return weight / std::hypot(x, b * root);
              },
              -1.0, 1.0);
        },
        -1.0, 1.0);
  };
  return Rule::integrate(
      [&](double x) {
        return Rule::integrate([&](double s) { return between(x - s); }, positions.edge(j),
                               positions.edge(j + 1));
      },
      positions.edge(i), positions.edge(i + 1));
}

TEST(StripInfluence, IsTheIntegralOverBothElements) {
  const LengthGrid positions = grid();
  const MatrixXd matrix = influence(0.0);
  for (const auto& [i, j] : {std::pair<Index, Index>{12, 10}, {12, 5}, {23, 20}, {23, 0}}) {
    const double b = std::sqrt(0.5 * (std::pow(widths(positions)(i), 2) + std::pow(widths(positions)(j), 2)));
    const double exact = by_quadrature(positions, i, j, b);
    EXPECT_NEAR(matrix(i, j), exact, kTable * exact) << i << " " << j;
  }
}

TEST(StripInfluence, IsSymmetricAndPositive) {
  for (const double factor : {0.0, 0.695, 1.39}) {
    const MatrixXd matrix = influence(factor);
    EXPECT_EQ((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_GT(mechanics::symmetric_modes(matrix).values(0), 0.0);
  }
}

TEST(StripInfluence, WideningIsTheSlopeByTheCommonWidth) {
  // All widths grow together by a share e: dW_ij/de = -2 B_ij^2 V_ij.
  const double e = 1e-3;
  for (const double factor : {0.0, 0.695}) {
    const MatrixXd slope = (influence(factor, 1.0 + e) - influence(factor, 1.0 - e)) / (2.0 * e);
    StripMatrices matrices;
    StripInfluence(grid(), factor).evaluate(widths(grid()), matrices);
    const Eigen::VectorXd square = widths(grid()).square().matrix();
    const MatrixXd common = 0.5 * (square.replicate(1, 24) + square.transpose().replicate(24, 1));
    const MatrixXd expected = -2.0 * common.cwiseProduct(matrices.widening);
    EXPECT_LE((slope - expected).cwiseAbs().maxCoeff(), kDifference * expected.cwiseAbs().maxCoeff());
  }
}

// A body cut at the end and mirrored there is one of twice the length with twice the load.
TEST(StripInfluence, FullMirrorIsTheOtherHalfOfALongerBody) {
  const LengthGrid half = graded_grid(kLength, 12, 0.0), whole = graded_grid(2.0 * kLength, 24, 0.0);
  StripMatrices mirrored, longer;
  StripInfluence(half, 1.0).evaluate(ArrayXd::Constant(12, 60e-6), mirrored);
  StripInfluence(whole, 0.0).evaluate(ArrayXd::Constant(24, 60e-6), longer);
  StripMatrices plain;
  StripInfluence(half, 0.0).evaluate(ArrayXd::Constant(12, 60e-6), plain);
  // Element i from the right end and its image, element j: those beyond the middle of the longer body.
  for (Index i = 0; i < 12; ++i) {
    for (Index j = 0; j < 12; ++j) {
      const double right = longer.influence(i, 23 - j), left = longer.influence(11 - i, 12 + j);
      const double images = mirrored.influence(i, j) - plain.influence(i, j);
      EXPECT_NEAR(images, right + left, 1e-9 * images) << i << " " << j;
    }
  }
}

TEST(StripInfluence, ScalesWithAllLengths) {
  const LengthGrid positions = grid();
  LengthGrid larger = graded_grid(3.0 * kLength, 24);
  StripMatrices matrices;
  StripInfluence(larger, 0.695).evaluate(3.0 * widths(positions), matrices);
  const MatrixXd ratio = matrices.influence.cwiseQuotient(influence(0.695));
  // 1/r over two lengths: one power of length.
  EXPECT_LE((ratio.array() - 3.0).abs().maxCoeff(), 1e3 * kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::half_space::strip_influence_test
