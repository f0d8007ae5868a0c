// The band of drops around the best, and what each duty does to a crown.
#include "coupling/study/crowning/crown_band.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::study::crowning::crown_band_test {
namespace {

constexpr double kHalved = 2e-3;  // of the way to an end: ten halvings leave a thousandth

const std::vector<double> kTilts{0.0, 1e-3};

double shortest(const CrownProblem& problem, const ProfileFamily& family, double drop) {
  const bearing::profile::Profile made = profile_of(family, {drop, usual_share(family)});
  return std::min(life_hours(problem, made, kTilts[0]), life_hours(problem, made, kTilts[1]));
}

TEST(CrownBand, EndsWhereATwentiethOfTheLifeIsLost) {
  const CrownProblem problem = problem_at(6000.0, LifeMeasure::lundberg_palmgren);
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1.0);
  const Crown best{1.5e-6, usual_share(family)};
  const DropBand band = drop_band(problem, family, best, kTilts, 10e-6, 2);
  const double required = kKeptLife * shortest(problem, family, best.drop);
  EXPECT_LT(band.least, best.drop);
  EXPECT_GT(band.most, best.drop);
  EXPECT_FALSE(band.open);
  EXPECT_GE(shortest(problem, family, band.most), required);
  EXPECT_LT(shortest(problem, family, band.most + kHalved * 10e-6), required);
  if (band.least > 0.0) {
    EXPECT_GE(shortest(problem, family, band.least), required);
    EXPECT_LT(shortest(problem, family, band.least - kHalved * best.drop), required);
  }
  EXPECT_TRUE(drop_band(problem, family, best, kTilts, 1.6e-6, 2).open);
}

TEST(CrownBand, NeedsNoDropWhereStraightRollersLiveAsLong) {
  const CrownProblem problem = problem_at(6000.0, LifeMeasure::lundberg_palmgren);
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1.0);
  EXPECT_EQ(drop_band(problem, family, {0.0, usual_share(family)}, {0.0}, 10e-6, 2).least, 0.0);
}

TEST(CrownBand, DutiesShareTheDamageByMinersRule) {
  const CrownProblem problem =
      problem_at({{1000.0 * kRpm, 0.25}, {9000.0 * kRpm, 0.75}}, LifeMeasure::lundberg_palmgren);
  const RollerPressure pressure(problem);
  const bearing::profile::Profile made = bearing::profile::Straight{};
  const std::vector<DutyRecord> found = duty_records(problem, pressure, made, kTilts, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].damage_share + found[1].damage_share, 1.0, 1e-12);
  EXPECT_NEAR(found[0].damage_share / found[1].damage_share,
              0.25 / found[0].life_hours / (0.75 / found[1].life_hours), 1e-9);
  EXPECT_EQ(found[0].tilt, 1e-3);
  EXPECT_GT(found[0].pressure.peak, 1e8);
}

}  // namespace
}  // namespace orbearing::study::crowning::crown_band_test
