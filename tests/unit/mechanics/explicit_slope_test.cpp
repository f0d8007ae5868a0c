// Issue 18, Build 5: slopes of explicit maps by extrapolated differences.
#include "mechanics/explicit_slope.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::mechanics::explicit_slope_test {
namespace {

constexpr double kRoundOff = 1e-12;

Eigen::VectorXd only(double value) {
  return Eigen::VectorXd::Constant(1, value);
}

// 3 + 2 x + x^n: both have the slope 2 at zero, if their order is high enough.
auto polynomial(int n) {
  return [n](double x) { return only(3.0 + 2.0 * x + std::pow(x, n)); };
}

TEST(ExplicitSlope, IsOfOrderSixToBothSides) {
  for (const int n : {2, 3, 4, 5, 6})
    EXPECT_NEAR(central_slope(polynomial(n), only(3.0), 1.0).slope[0], 2.0, kRoundOff) << n;
  // The seventh power alone is left, and goes with the sixth power of the step.
  const double whole = central_slope(polynomial(7), only(3.0), 1.0).slope[0] - 2.0;
  const double half = central_slope(polynomial(7), only(3.0), 0.5).slope[0] - 2.0;
  EXPECT_NEAR(whole / half, 64.0, 1e-6);
}

TEST(ExplicitSlope, IsOfOrderFourToOneSide) {
  for (const double step : {1.0, -1.0}) {
    for (const int n : {2, 3, 4})
      EXPECT_NEAR(one_sided_slope(polynomial(n), only(3.0), step).slope[0], 2.0, kRoundOff) << n;
    const double whole = one_sided_slope(polynomial(5), only(3.0), step).slope[0] - 2.0;
    const double half = one_sided_slope(polynomial(5), only(3.0), 0.5 * step).slope[0] - 2.0;
    EXPECT_NEAR(whole / half, 16.0, 1e-6);
  }
}

TEST(ExplicitSlope, EstimatesNoLessThanItsError) {
  const auto wave = [](double x) { return only(std::exp(std::sin(x + 0.3))); };
  const double exact = std::cos(0.3) * std::exp(std::sin(0.3));
  for (const double step : {0.5, 0.1}) {
    const ExplicitSlope both = central_slope(wave, wave(0.0), step),
                        one = one_sided_slope(wave, wave(0.0), step);
    EXPECT_LE(std::abs(both.slope[0] - exact), std::abs(both.last_change[0]));
    EXPECT_LE(std::abs(one.slope[0] - exact), std::abs(one.last_change[0]));
  }
}

TEST(ExplicitSlope, KnowsAKinkByItsBend) {
  const ExplicitSlope kink = central_slope([](double x) { return only(std::abs(x)); }, only(0.0), 0.1);
  EXPECT_NEAR(kink.bend[0], 2.0, kRoundOff);
  EXPECT_NEAR(kink.bend_near[0], 2.0, kRoundOff);
  const ExplicitSlope smooth = central_slope([](double x) { return only(x * x); }, only(0.0), 0.1);
  EXPECT_NEAR(smooth.bend_near[0], 0.36 * smooth.bend[0], kRoundOff);
}

}  // namespace
}  // namespace orbearing::mechanics::explicit_slope_test
