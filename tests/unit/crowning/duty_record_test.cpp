// Effects of each duty on a crown.
#include "coupling/analysis/crowning/crown_grid.hpp"

#include <gtest/gtest.h>

#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::duty_record_test {
namespace {

const std::vector<double> kTilts{0.0, 1e-3};

TEST(DutyRecord, DutiesShareTheDamageByMinersRule) {
  const CrownProblem problem =
      problem_at({{1000.0 * kRpm, 0.25}, {9000.0 * kRpm, 0.75}}, LifeMethod::lundberg_palmgren);
  const RollerPressure pressure(problem);
  const bearing::profile::Profile made = bearing::profile::Straight{};
  const std::vector<DutyRecord> found = duty_records(problem, pressure, made, kTilts, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].damage_share + found[1].damage_share, 1.0, 1e-12);
  EXPECT_NEAR(found[0].damage_share / found[1].damage_share,
              0.25 / found[0].life_hours / (0.75 / found[1].life_hours), 1e-9);
  EXPECT_NEAR(found[0].tilt, 1e-3, 1e-15);
  EXPECT_GT(found[0].pressure.peak, 1e8);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::duty_record_test
