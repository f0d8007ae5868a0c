// The best crown: against a fine grid, from many starts, within a band of tolerance.
#include "coupling/analysis/crowning/crown_optimum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/analysis/crowning/crown_grid.hpp"
#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::crown_optimum_test {
namespace {

const std::vector<double> kTilts{0.0, 1e-3, 2e-3};

double best_of_grid(const CrownProblem& problem, const ProfileFamily& family,
                    const std::vector<Member>& members, double least, double step, int steps) {
  double best = 0.0;
  for (int i = 0; i <= steps; ++i)
    best =
        std::max(best, worst_life_hours(problem, family, {least + step * i, default_share(family)}, members));
  return best;
}

TEST(CrownOptimum, TenStartsEndInOneThatNoGridPointBeats) {
  for (const LifeMethod measure : {LifeMethod::lundberg_palmgren, LifeMethod::iso16281}) {
    const CrownProblem problem = problem_at(6000.0, measure);
    const ProfileFamily family = family_of("iso16281", problem.bearing, 1500.0);
    const auto members = members_of(kTilts, {});
    const CrownOptimum best = best_crown(problem, family, members, {.greatest_drop = 20e-6});
    EXPECT_EQ(best.ends.size(), 10u);
    EXPECT_EQ(best.in_best, static_cast<int>(best.ends.size())) << static_cast<int>(measure);
    const double grid = best_of_grid(problem, family, members, 0.0, 0.25e-6, 80);
    EXPECT_GE(best.life_hours, grid);
    EXPECT_LT(best.life_hours, 1.01 * grid);  // between two points of the grid it is not far above both
    EXPECT_GT(best.crown.drop, 1e-6);
  }
}

// Without tilt, edges without edge stress are best left straight.
TEST(CrownOptimum, UntiltedWithoutEdgeStressIsStraight) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::lundberg_palmgren);
  const ProfileFamily family = family_of("circular", problem.bearing, 1500.0);
  const CrownOptimum best = best_crown(problem, family, members_of({0.0}, {}), {.greatest_drop = 20e-6});
  EXPECT_NEAR(best.crown.drop, 0.0, 1e-9);
}

TEST(CrownOptimum, WithinABandTheWorstIsBestWhereTheBandIsAllowedFor) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1500.0);
  const auto plain = members_of(kTilts, {}), band = members_of(kTilts, {2e-6, 0.5e-3});
  EXPECT_EQ(band.size(), 12u);
  const SearchOptions options{.greatest_drop = 20e-6, .least_drop = 2e-6, .starts = 3};
  const CrownOptimum nominal = best_crown(problem, family, plain, options);
  const CrownOptimum robust = best_crown(problem, family, band, options);
  EXPECT_EQ(robust.in_best, static_cast<int>(robust.ends.size()));
  EXPECT_GT(robust.life_hours, worst_life_hours(problem, family, nominal.crown, band));
  EXPECT_LT(robust.life_hours, nominal.life_hours);
  EXPECT_GT(robust.crown.drop, nominal.crown.drop);
}

TEST(CrownOptimum, TheShareIsFoundWithTheDrop) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const ProfileFamily family = family_of("straight-circular", problem.bearing, 1500.0);
  const auto members = members_of({2e-3}, {});
  SearchOptions options{.greatest_drop = 20e-6, .starts = 4};
  const CrownOptimum both = best_crown(problem, family, members, options);
  options.free_share = false;
  const CrownOptimum drop_alone = best_crown(problem, family, members, options);
  EXPECT_DOUBLE_EQ(drop_alone.crown.share, default_share(family));
  EXPECT_GT(both.life_hours, drop_alone.life_hours);
}

TEST(CrownGrid, DoesNotDependOnThreadsAndMarksTheFront) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const RollerPressure pressure(problem);
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1500.0);
  const std::vector<double> drops{0.0, 3e-6, 6e-6, 12e-6};
  std::vector<bearing::profile::Profile> profiles;
  for (const double drop : drops) profiles.push_back(profile_of(family, {drop, 1.0}));
  const auto one = crown_grid(problem, pressure, profiles, drops, kTilts, 1, {});
  const auto two = crown_grid(problem, pressure, profiles, drops, kTilts, 2, {});
  ASSERT_EQ(one.size(), 12u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].life_hours, two[i].life_hours);
    EXPECT_EQ(one[i].pressure.peak, two[i].pressure.peak);
    EXPECT_EQ(one[i].status, "ok");
  }
  const auto worst = worst_of_tilts(one, kTilts.size());
  ASSERT_EQ(worst.size(), 4u);
  EXPECT_FALSE(worst[0].efficient);  // the sharp edge of a straight roller presses hardest and lives shorter
  EXPECT_GT(worst[0].peak_pressure, worst[1].peak_pressure);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::crown_optimum_test
