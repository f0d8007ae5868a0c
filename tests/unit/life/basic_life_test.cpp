#include "bearing/life/basic_life.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::bearing::rating::basic_life_test {
namespace {

constexpr double kRoundOff = 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(BasicLife, PowersOfTheLoad) {
  EXPECT_NEAR(basic_rating_life(RollingElement::ball, 2000.0, 1000.0), 8e6, 8e6 * kRoundOff);
  EXPECT_NEAR(basic_rating_life(RollingElement::roller, 8000.0, 1000.0), 1024e6, 1024e6 * kRoundOff);
  EXPECT_EQ(basic_rating_life(RollingElement::ball, 2000.0, 0.0), kInfinity);
}

TEST(BasicLife, ReferenceLoadIsTheInverse) {
  for (const RollingElement element : {RollingElement::ball, RollingElement::roller})
    EXPECT_NEAR(reference_load(element, 5000.0, basic_rating_life(element, 5000.0, 700.0)), 700.0,
                700.0 * kRoundOff);
}

// A share R of them reaches [ln(1/R)/ln(1/0.9)]^(1/e) L10.
TEST(Reliability, OfWeibull) {
  for (const RollingElement element : {RollingElement::ball, RollingElement::roller})
    for (const double reliability : {0.01, 0.5, 0.9, 0.99, 0.9999}) {
      const double slope = weibull_slope(element);
      const double ratio = std::pow(std::log(1.0 / reliability) / std::log(1.0 / 0.9), 1.0 / slope);
      EXPECT_NEAR(weibull_reliability(ratio, slope), reliability, kRoundOff);
    }
  EXPECT_NEAR(weibull_reliability(1.0, 9.0 / 8.0), 0.9, kRoundOff);
  // Half of all ball bearings reach (ln 2/ln(1/0.9))^0.9 = 5.449 L10.
  EXPECT_NEAR(weibull_reliability(5.4492, 10.0 / 9.0), 0.5, 5e-6);
}

TEST(Reliability, OutsideZeroToOneIsRefused) {
  for (const double reliability : {0.0, 1.0, -1.0, 2.0, std::nan("")})
    EXPECT_REFUSED(std::invalid_argument, "basic_life 1", reliability_factor(reliability));
}

TEST(Spectrum, SharesOverLives) {
  const Eigen::Array2d shares(0.25, 0.75), lives(100.0, 300.0);
  EXPECT_NEAR(spectrum_life(shares, lives), 200.0, 200.0 * kRoundOff);
  EXPECT_NEAR(spectrum_life(shares, Eigen::Array2d(100.0, kInfinity)), 400.0, 400.0 * kRoundOff);
  EXPECT_EQ(spectrum_life(shares, Eigen::Array2d(kInfinity, kInfinity)), kInfinity);
}

TEST(Spectrum, SharesThatAreNoneAreRefused) {
  const Eigen::Array2d lives(100.0, 300.0);
  EXPECT_REFUSED(std::invalid_argument, "basic_life 2", spectrum_life(Eigen::Array2d(0.5, 0.6), lives));
  EXPECT_REFUSED(std::invalid_argument, "basic_life 3", spectrum_life(Eigen::Array2d(-0.5, 1.5), lives));
  EXPECT_REFUSED(std::invalid_argument, "basic_life 4",
                 spectrum_life(Eigen::Array3d(0.5, 0.25, 0.25), lives));
}

TEST(System, EqualBearingsAndOneThatNeverFails) {
  const double slope = weibull_slope(RollingElement::roller);
  EXPECT_NEAR(system_life(Eigen::ArrayXd::Constant(8, 5000.0), slope), 5000.0 * std::pow(8.0, -8.0 / 9.0),
              5000.0 * kRoundOff);
  EXPECT_NEAR(system_life(Eigen::Array2d(700.0, kInfinity), slope), 700.0, 700.0 * kRoundOff);
  EXPECT_EQ(system_life(Eigen::Array2d(kInfinity, kInfinity), slope), kInfinity);
}

// The probability that all survive the system's life is the product of the bearings' own.
TEST(System, ReliabilitiesMultiply) {
  const double slope = weibull_slope(RollingElement::ball);
  const Eigen::Array3d lives(100.0, 250.0, 80.0);
  const double together = system_life(lives, slope);
  double product = 1.0;
  for (const double life : lives) product *= weibull_reliability(together / life, slope);
  EXPECT_NEAR(product, 0.9, kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::rating::basic_life_test
