#include "gearset/mesh/periodic_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::gearset::periodic_curve_test {
namespace {

constexpr double kRoundOff = 1e-13;  // relative, of a handful of operations
constexpr double kBeside = 1e-8;     // what sampling a billionth of the period beside a jump may cost

double wave(double f) {
  return std::sin(2.0 * std::numbers::pi * f);
}
double wave_slope(double f) {
  return 2.0 * std::numbers::pi * std::cos(2.0 * std::numbers::pi * f);
}
// Two teeth in contact for half of the period, one for the rest; curved on both pieces.
double steps(double f) {
  return f >= 0.2 && f < 0.7 ? 4.0 - (f - 0.4) * (f - 0.4) : 2.0 + 0.5 * wave(f);
}

double worst_error(int samples) {
  const PeriodicCurve curve(wave, {}, samples);
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) worst = std::max(worst, std::abs(curve.value(1e-3 * i) - wave(1e-3 * i)));
  return worst;
}

TEST(PeriodicCurve, ConvergesWithTheFourthPower) {
  const double order = std::log2(worst_error(32) / worst_error(64));
  EXPECT_NEAR(order, 4.0, 0.1);
}

TEST(PeriodicCurve, ConvergesWithTheFourthPowerBetweenJumps) {
  const auto worst = [](int samples) {
    const PeriodicCurve curve(steps, {0.2, 0.7}, samples);
    double error = 0.0;
    for (int i = 0; i < 1000; ++i)
      error = std::max(error, std::abs(curve.value(1e-3 * i + 5e-4) - steps(1e-3 * i + 5e-4)));
    return error;
  };
  EXPECT_GT(std::log2(worst(40) / worst(80)), 3.5);
}

TEST(PeriodicCurve, SlopeIsTheDerivativeOfTheValue) {
  const PeriodicCurve curve(steps, {0.2, 0.7}, 30);
  const double h = 1e-6;
  for (const double f : {0.05, 0.1999, 0.2001, 0.31, 0.6999, 0.7001, 0.99}) {
    const double difference = (curve.value(f + h) - curve.value(f - h)) / (2.0 * h);
    EXPECT_NEAR(curve.slope(f), difference, 1e-8) << f;  // h^2 times a third derivative of order 100
  }
}

TEST(PeriodicCurve, SlopeIsContinuousInsidePiecesAndRoundThePeriod) {
  const int samples = 16;
  const PeriodicCurve curve(wave, {}, samples);
  for (int i = 0; i <= samples; ++i) {
    const double knot = static_cast<double>(i) / samples;
    EXPECT_NEAR(curve.slope(knot - 1e-12), curve.slope(knot + 1e-12), 1e-8);
    EXPECT_NEAR(curve.slope(knot), wave_slope(knot), 3e-2);  // h^4 f'''''/30
  }
}

TEST(PeriodicCurve, HasBothLimitsAtAJump) {
  const PeriodicCurve curve(steps, {0.2, 0.7}, 100);
  EXPECT_NEAR(curve.value(0.2), 4.0 - 0.04, kBeside);
  EXPECT_NEAR(curve.value(0.2 - 1e-12), 2.0 + 0.5 * wave(0.2), kBeside);
  EXPECT_NEAR(curve.value(0.7), 2.0 + 0.5 * wave(0.7), kBeside);
  EXPECT_NEAR(curve.value(std::nextafter(0.7, 0.0)), 4.0 - 0.09, kBeside);
}

TEST(PeriodicCurve, RepeatsForAnyRealFraction) {
  const PeriodicCurve curve(steps, {0.2, 0.7}, 50);
  for (const double f : {0.0, 0.125, 0.25, 0.6875, 0.75})
    for (const double turns : {-1024.0, -1.0, 1.0, 3.0, 4096.0})
      EXPECT_NEAR(curve.value(f + turns), curve.value(f), kRoundOff);
  EXPECT_TRUE(std::isfinite(curve.value(0.2 - 1e-18)));
  EXPECT_TRUE(std::isfinite(curve.value(-1e-18)));
}

TEST(PeriodicCurve, MeanIsTheIntegral) {
  // 0.5 * 4 - [(f - 0.4)^3 / 3] from 0.2 to 0.7, and the rest of the period of 2 + wave / 2.
  const double wave_part =
      (std::cos(0.4 * std::numbers::pi) - std::cos(1.4 * std::numbers::pi)) / (2.0 * std::numbers::pi);
  const double exact = 2.0 - (0.027 + 0.008) / 3.0 + 1.0 - 0.5 * wave_part;
  EXPECT_NEAR(PeriodicCurve(steps, {0.2, 0.7}, 200).mean(), exact, kBeside);
}

TEST(PeriodicCurve, ConstantIsConstant) {
  const PeriodicCurve curve = PeriodicCurve::constant(5e8);
  EXPECT_EQ(curve.value(0.3), 5e8);
  EXPECT_EQ(curve.slope(-7.7), 0.0);
  EXPECT_EQ(curve.mean(), 5e8);
  EXPECT_TRUE(curve.jumps().empty());
  EXPECT_EQ(PeriodicCurve().value(0.5), 0.0);
}

TEST(PeriodicCurve, BoundsAreThoseOfTheKnots) {
  const PeriodicCurve curve(steps, {0.2, 0.7}, 400);
  EXPECT_NEAR(curve.largest(), 4.0, 1e-4);
  EXPECT_NEAR(curve.least(), 1.5, 1e-4);
}

TEST(PeriodicCurve, RefusesJumpsOutOfOrderAndValuesThatAreNone) {
  EXPECT_REFUSED(std::invalid_argument, "periodic_curve 1", PeriodicCurve(steps, {0.7, 0.2}, 10));
  EXPECT_REFUSED(std::invalid_argument, "periodic_curve 2", PeriodicCurve(steps, {1.0}, 10));
  EXPECT_REFUSED(std::invalid_argument, "periodic_curve 3", PeriodicCurve(steps, {0.2, 0.2}, 10));
  const auto nothing = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_REFUSED(std::invalid_argument, "periodic_curve 4", PeriodicCurve(nothing, {}, 10));
}

}  // namespace
}  // namespace orbearing::gearset::periodic_curve_test
