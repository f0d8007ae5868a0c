// The drop by half-space pressures, its band, and the effect of missing it.
#include "coupling/analysis/crowning/half_space_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::half_space_search_test {
namespace {

constexpr double kCurve = 1e-2;  // of a life between its nodes: twice what the search requires at the best

TEST(DropCurve, IsThePolynomialThroughItsNodes) {
  const auto cubic = [](double x) { return 2.0 - x + 3.0 * x * x * x; };
  const Eigen::ArrayXd nodes = curve_nodes(2.0, 3);
  const DropCurve curve(2.0, nodes.unaryExpr(cubic));
  for (const double x : {0.0, 0.1, 0.77, 1.5, 2.0}) EXPECT_NEAR(curve(x), cubic(x), 1e-13);
  EXPECT_EQ(curve(9.0), curve(2.0));
  const Eigen::ArrayXd finer = curve_nodes(2.0, 6);
  for (int k = 0; k <= 3; ++k) EXPECT_NEAR(finer[2 * k], nodes[k], 1e-15);
}

double shortest(const CrownProblem& problem, const RollerPressure& pressure, const ProfileFamily& family,
                double drop, const std::vector<double>& tilts) {
  const auto lives = pressure_lives(problem, pressure, profile_of(family, {drop, 1.0}), tilts, 2);
  return *std::min_element(lives.begin(), lives.end());
}

TEST(HalfSpaceAdvice, IsWhereTheShortestLifeIsLongest) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::lundberg_palmgren);
  const RollerPressure pressure(problem);
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1.0);
  const std::vector<double> tilts{0.0, 1e-3};
  const HalfSpaceAdvice found = half_space_advice(
      problem, pressure, family, 1.0,
      {.tilts = tilts, .greatest_drop = 10e-6, .miss = 0.5e-6, .other_drop = 4e-6, .jobs = 2});
  const auto life = [&](double drop) { return shortest(problem, pressure, family, drop, tilts); };
  const double best = life(found.drop);
  EXPECT_NEAR(found.life_hours, best, kCurve * best);
  EXPECT_GT(found.drop, 0.1e-6);
  // Between the 801 drops of the first scan, not one of them.
  const double scanned = found.drop / 10e-6 * 800.0;
  EXPECT_GT(std::abs(scanned - std::round(scanned)), 1e-3);
  for (const double step : {-0.3e-6, 0.3e-6}) EXPECT_LT(life(found.drop + step), (1.0 + kCurve) * best);
  EXPECT_NEAR(found.straight_life_hours, life(0.0), kCurve * best);
  EXPECT_NEAR(found.other.life_share, life(4e-6) / best, kCurve);
  EXPECT_NEAR(found.high.life_share, life(found.drop + 0.5e-6) / best, kCurve);
  EXPECT_DOUBLE_EQ(found.low.drop, std::max(found.drop - 0.5e-6, 0.0));
  EXPECT_NEAR(found.low.life_share, life(found.low.drop) / best, kCurve);
  EXPECT_LE(found.interpolation_error, 5e-3);
  EXPECT_FALSE(found.band.open);
  EXPECT_NEAR(life(found.band.most) / best, kKeptLife, kCurve);
  EXPECT_GE(life(found.band.least) / best, kKeptLife - kCurve);
  EXPECT_EQ(found.curve.front().drop, 0.0);
  EXPECT_EQ(found.quadrature_error, 0.0);
}

TEST(HalfSpaceAdvice, NeedsNoCrownWhereNothingLeans) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::lundberg_palmgren);
  const HalfSpaceAdvice found =
      half_space_advice(problem, RollerPressure(problem), family_of("iso16281", problem.bearing, 1.0), 1.0,
                        {.greatest_drop = 10e-6, .jobs = 2});
  EXPECT_TRUE(found.no_crown_needed());
  EXPECT_EQ(found.band.least, 0.0);
  EXPECT_FALSE(half_space_advice(problem, RollerPressure(problem),
                                 family_of("iso16281", problem.bearing, 1.0), 1.0,
                                 {.tilts = {2e-3}, .greatest_drop = 10e-6, .jobs = 2})
                   .no_crown_needed());
}

TEST(HalfSpaceAdvice, BandIsOpenAtTheGreatestDropStudied) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::lundberg_palmgren);
  EXPECT_TRUE(half_space_advice(problem, RollerPressure(problem), family_of("iso16281", problem.bearing, 1.0),
                                1.0, {.tilts = {2e-3}, .greatest_drop = 2e-6, .jobs = 2})
                  .band.open);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::half_space_search_test
