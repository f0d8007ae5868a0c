// Tolerances weighted by probability.
#include "coupling/analysis/crowning/half_space_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::tolerance_population_test {
namespace {

constexpr double kRoundOff = 1e-12;

double moment(const Misses& misses, int degree) {
  return (misses.weight * misses.miss.pow(degree)).sum();
}

// The moments of the uniform density are 1/(k + 1), k even.
TEST(Misses, UniformOnesHaveTheMomentsOfTheirDensity) {
  const Misses found = misses_of(Distribution::uniform, 4);
  for (int degree = 0; degree < 8; ++degree)
    EXPECT_NEAR(moment(found, degree), degree % 2 == 0 ? 1.0 / (degree + 1) : 0.0, kRoundOff) << degree;
}

// The normal density is cut off at three deviations: variance s^2 (1 - 2 a p(a)/(2 P(a) - 1)), a = 3, p and P
// of the standard normal distribution.
TEST(Misses, NormalOnesAreCutOffAtThreeDeviations) {
  const double a = 3.0, p = std::exp(-0.5 * a * a) / std::sqrt(8.0 * std::atan(1.0));
  const double variance = (1.0 - 2.0 * a * p / std::erf(a / std::sqrt(2.0))) / (a * a);
  for (const int nodes : {2, 3, 8}) {
    const Misses found = misses_of(Distribution::normal, nodes);
    ASSERT_EQ(found.miss.size(), nodes);
    EXPECT_NEAR(moment(found, 0), 1.0, kRoundOff);
    EXPECT_NEAR(moment(found, 1), 0.0, kRoundOff);
    EXPECT_NEAR(moment(found, 2), variance, kRoundOff);
    EXPECT_LT(found.miss.abs().maxCoeff(), 1.0);
  }
}

TEST(PopulationLife, OfPlanetsAlikeIsTheirLife) {
  EXPECT_NEAR(population_life(Eigen::Array2d(700.0, 700.0), Eigen::Array2d(0.3, 0.7)), 700.0,
              700.0 * kRoundOff);
}

// If half of them never fail, a fifth of the other half may fail.
TEST(PopulationLife, IsWhatNineTenthsReach) {
  const double never = std::numeric_limits<double>::infinity();
  const double expected = 100.0 * std::pow(std::log(0.8) / std::log(0.9), 8.0 / 9.0);
  EXPECT_NEAR(population_life(Eigen::Array2d(100.0, never), Eigen::Array2d(0.5, 0.5)), expected,
              expected * kRoundOff);
}

// Small scatter: 1 - S is about (t/L)^e ln(1/0.9), so that lives sum up as those of one system do.
TEST(PopulationLife, OfSmallScatterIsThePowerMean) {
  constexpr double scatter = 1e-3, second_order = scatter * scatter;
  const double expected =
      std::pow(0.5 * (std::pow(1.0 + scatter, -9.0 / 8.0) + std::pow(1.0 - scatter, -9.0 / 8.0)), -8.0 / 9.0);
  EXPECT_NEAR(population_life(Eigen::Array2d(1.0 + scatter, 1.0 - scatter), Eigen::Array2d(0.5, 0.5)),
              expected, second_order);
  EXPECT_LT(expected, 1.0);
}

TEST(Population, OfStatedTiltsIsTheirWorst) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::lundberg_palmgren);
  const Population found = population_of(problem, {0.0, 1e-3}, {1e-6, 0.25e-3}, Distribution::normal);
  EXPECT_TRUE(found.worst);
  ASSERT_EQ(found.leans.size(), 4u);
  EXPECT_EQ(found.leans.back().lean, Lean(1.25e-3, 0.0));
  EXPECT_EQ(found.drop_miss.size(), 2);
  Eigen::ArrayXXd hours = Eigen::ArrayXXd::Constant(4, 2, 9.0);
  hours(2, 1) = 5.0;
  EXPECT_EQ(life_of(found, hours), 5.0);
}

TEST(Population, OfComputedTiltsLeansInBothDirections) {
  CrownProblem problem = problem_at(6000.0, LifeMethod::lundberg_palmgren);
  problem.seat.emplace();
  const Population found = population_of(problem, {0.0}, {1e-6, 0.3e-3}, Distribution::uniform, {3, 5});
  EXPECT_FALSE(found.worst);
  ASSERT_EQ(found.leans.size(), 9u);
  ASSERT_EQ(found.drop_miss.size(), 5);
  double sum = 0.0;
  Lean squares = Lean::Zero();
  for (const LeanPart& part : found.leans) {
    sum += part.weight;
    squares += part.weight * part.lean.cwiseAbs2();
  }
  EXPECT_NEAR(sum, 1.0, kRoundOff);
  for (const double square : squares) EXPECT_NEAR(square / (0.3e-3 * 0.3e-3), 1.0 / 3.0, kRoundOff);
  EXPECT_NEAR((found.drop_weight * found.drop_miss.square()).sum() / 1e-12, 1.0 / 3.0, kRoundOff);
  EXPECT_EQ(population_of(problem, {0.0}, {}, Distribution::normal).leans.size(), 1u);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::tolerance_population_test
