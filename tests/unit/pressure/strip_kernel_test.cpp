#include "bearing/pressure/strip_influence.hpp"
#include "mechanics/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::bearing::half_space::strip_kernel_test {
namespace {

using constants::pi;

constexpr double kTable = 1e-9;       // as promised
constexpr double kQuadrature = 1e-5;  // mean over 400 x 400 places of two semi-ellipses, as 1/N^2
constexpr double kSlope = 1e-6;       // central difference with a step of 1e-3

/// Mean of 1/sqrt(xi^2 + (t - t')^2) over two semi-ellipses: Gauss-Chebyshev places of the second kind.
double mean_reciprocal(double xi) {
  const int n = 400;
  double sum = 0.0;
  for (int i = 1; i <= n; ++i) {
    for (int j = 1; j <= n; ++j) {
      const double a = pi * i / (n + 1), b = pi * j / (n + 1);
      const double weight = std::pow(2.0 / (n + 1) * std::sin(a) * std::sin(b), 2);
      sum += weight / std::hypot(xi, std::cos(a) - std::cos(b));
    }
  }
  return sum;
}

TEST(StripKernel, MeanDistanceOfTwoSemiEllipsesIsTheClosedForm) {
  EXPECT_NEAR(strip_kernel_by_quadrature(0.0).spread, 256.0 / (45.0 * pi * pi), kTable);
}

TEST(StripKernel, TableAndExpansionAgreeWithTheQuadrature) {
  for (double xi = 1e-3; xi < 50.0; xi *= 1.0171) {
    const StripKernel fast = strip_kernel(xi), exact = strip_kernel_by_quadrature(xi);
    EXPECT_NEAR(fast.potential, exact.potential, kTable) << xi;
    EXPECT_NEAR(fast.spread, exact.spread, kTable) << xi;
  }
}

TEST(StripKernel, SecondDerivativeIsTheMeanOfTheReciprocalDistance) {
  for (const double xi : {0.3, 1.0, 2.5, 7.0}) {
    const double h = 1e-2;
    const double bend =
        (strip_kernel_by_quadrature(xi + h).potential - 2.0 * strip_kernel_by_quadrature(xi).potential +
         strip_kernel_by_quadrature(xi - h).potential) /
        (h * h);
    // The second difference errs by h^2/12 of the fourth derivative, 24/xi^5 far away and less near by.
    EXPECT_NEAR(bend, mean_reciprocal(xi), kQuadrature + h * h / 12.0 * 24.0 / (1.0 + std::pow(xi, 5))) << xi;
  }
}

TEST(StripKernel, SpreadIsMinusTheSlopeByTheWidth) {
  // d[b potential(x/b)]/db at b = 1.
  for (const double x : {0.1, 0.9, 3.0, 9.9, 10.1, 40.0}) {
    const double h = 1e-3;
    const auto scaled = [&](double b) { return b * strip_kernel_by_quadrature(x / b).potential; };
    EXPECT_NEAR(-(scaled(1.0 + h) - scaled(1.0 - h)) / (2.0 * h), strip_kernel(x).spread, kSlope * (1.0 + x));
  }
}

}  // namespace
}  // namespace orbearing::bearing::half_space::strip_kernel_test
