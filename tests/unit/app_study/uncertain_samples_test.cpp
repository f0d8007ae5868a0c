// Samples of uncertain inputs against the quantiles and moments of their distributions.
#include "app/study/uncertain_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbearing::app::uncertain_samples_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int kSamples = 2000;

UncertainInput input(const std::string& distribution, double mean, double deviation, double from, double peak,
                     double to) {
  UncertainInput one;
  one.distribution = distribution;
  one.mean = mean;
  one.standard_deviation = deviation;
  one.from = from;
  one.peak = peak;
  one.to = to;
  return one;
}

// Moments of the input sampled alone: (mean, standard deviation).
std::pair<double, double> moments(const UncertainInput& one) {
  double sum = 0.0, squares = 0.0;
  for (const std::vector<double>& sample : uncertain_samples({{one}, {{1.0}}}, kSamples, 1)) {
    sum += sample[0];
    squares += sample[0] * sample[0];
  }
  const double mean = sum / kSamples;
  return {mean, std::sqrt(squares / kSamples - mean * mean)};
}

// Midpoints of 2000 equal shares: exact to the share in the tails, here below a thousandth of the deviation.
TEST(UncertainSamples, HaveTheMomentsOfTheirDistributions) {
  const auto [mean, deviation] = moments(input("normal", 3.0, 0.5, none, none, none));
  EXPECT_NEAR(mean, 3.0, 5e-4);
  EXPECT_NEAR(deviation, 0.5, 1e-3);
  const auto [middle, spread] = moments(input("uniform", none, none, 1.0, none, 4.0));
  EXPECT_NEAR(middle, 2.5, 1e-3);
  EXPECT_NEAR(spread, 3.0 / std::sqrt(12.0), 1e-3);
  const auto [centre, width] = moments(input("triangular", none, none, 0.0, 1.0, 5.0));
  EXPECT_NEAR(centre, 6.0 / 3.0, 1e-3);
  EXPECT_NEAR(width, std::sqrt((1.0 + 25.0 - 5.0) / 18.0), 1e-3);
}

TEST(UncertainSamples, StayWithinTheEndsOfACutOffNormal) {
  const UncertainInput half = input("truncated-normal", 0.0, 1.0, 0.0, none, none);
  for (const std::vector<double>& sample : uncertain_samples({{half}, {{1.0}}}, kSamples, 1))
    EXPECT_GE(sample[0], 0.0);
  EXPECT_NEAR(moments(half).first, std::sqrt(2.0 / M_PI), 1e-3);
}

TEST(UncertainSamples, AreCorrelatedAsStated) {
  const UncertainInput one = input("normal", 0.0, 1.0, none, none, none);
  constexpr double stated = 0.8;
  double sum = 0.0;
  for (const std::vector<double>& sample :
       uncertain_samples({{one, one}, {{1.0, stated}, {stated, 1.0}}}, kSamples, 1))
    sum += sample[0] * sample[1];
  EXPECT_NEAR(sum / kSamples, stated, 3.0 / std::sqrt(kSamples));  // three standard errors of independent points
}

TEST(UncertainSamples, AreThoseOfTheirSeed) {
  const UncertainInput one = input("normal", 0.0, 1.0, none, none, none);
  const UncertainInputs two{{one, one}, {{1.0, 0.0}, {0.0, 1.0}}};
  EXPECT_EQ(uncertain_samples(two, 50, 3), uncertain_samples(two, 50, 3));
  EXPECT_NE(uncertain_samples(two, 50, 3), uncertain_samples(two, 50, 4));
}

}  // namespace
}  // namespace orbearing::app::uncertain_samples_test
