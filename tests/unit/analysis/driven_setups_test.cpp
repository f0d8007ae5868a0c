// Properties that a bearing driven by its gears takes over from its drivetrain.
#include "coupling/analysis/driven_setups.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reducer.hpp"

namespace orbearing::analysis::driven_setups_test {
namespace {

system::DrivenBearingSetup setup_at(double speed) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.drive.speed = speed;
  return driven_bearing_setup(drivetrain, derive(drivetrain));
}

// Speeds come from the gears while it moves, so that the limit is that of the speeds at the operating point.
TEST(DrivenSetups, FrictionOfASlowBearingBuildsUpOverAShareOfItsRolling) {
  PlanetaryDrivetrain slow = example::reducer();
  slow.drive.speed = 100.0 * example::rpm;
  const DrivetrainGeometry geometry = derive(slow);
  const bearing::OperatingPoint point = bearing_duty(slow, geometry).point;
  const double cage = 0.5 * point.outer_speed * (1.0 + 5.24 / 35.64);  // the pin is fixed to the carrier
  const double rolling = 0.5 * (35.64e-3 - 5.24e-3) * std::abs(cage);
  EXPECT_NEAR(setup_at(slow.drive.speed).dynamics.race.sliding_scale / (0.02 * rolling), 1.0, 1e-3);
  EXPECT_EQ(setup_at(60000.0 * example::rpm).dynamics.race.sliding_scale, 0.1);
}

}  // namespace
}  // namespace orbearing::analysis::driven_setups_test
