#include "bearing/motion/cage_pocket.hpp"

#include <gtest/gtest.h>

namespace orbearing::bearing::motion::cage_pocket_test {
namespace {

constexpr double kRoundOff = 1e-12;

const PocketModel kPocket{.half_clearance = 0.05e-3,
                          .stiffness = 3e7,
                          .damping = 1.0,
                          .friction = 0.05,
                          .sliding_scale = 0.1,
                          .roller_radius = 2.62e-3};
const Vector2 kOutward(1.0, 0.0);

BodyMotion roller_off_by(double offset) {
  return {Vector2(17.82e-3, offset), Vector2::Zero(), 0.0};
}
const BodyMotion kCage{Vector2::Zero(), Vector2::Zero(), 0.0};

TEST(CagePocket, LeavesTheRollerFreeWithinItsClearance) {
  const PocketForces forces = pocket_forces(kPocket, roller_off_by(0.049e-3), kCage, kOutward);
  EXPECT_EQ(forces.load, 0.0);
  EXPECT_EQ(forces.on_roller.force, Vector2(0.0, 0.0));
}

//  cage o-------( roller )|bar|   2 um into the bar ahead: 60 N back on the roller, ahead on the cage at its
//  radius
TEST(CagePocket, PushesRollerAndCageApart) {
  const PocketForces forces = pocket_forces(kPocket, roller_off_by(0.052e-3), kCage, kOutward);
  const double load = 3e7 * 2e-6;
  EXPECT_NEAR(forces.on_roller.force.y(), -load, kRoundOff * load);
  EXPECT_NEAR(forces.on_cage.force.y(), load, kRoundOff * load);
  EXPECT_NEAR(forces.on_cage.moment, 17.82e-3 * load, kRoundOff * load);
  EXPECT_NEAR(pocket_forces(kPocket, roller_off_by(-0.052e-3), kCage, kOutward).on_roller.force.y(), load,
              kRoundOff * load);
}

TEST(CagePocket, FrictionBrakesTheSpinOfTheRoller) {
  BodyMotion roller = roller_off_by(0.052e-3);
  roller.speed = 3000.0;
  const PocketForces forces = pocket_forces(kPocket, roller, kCage, kOutward);
  EXPECT_LT(forces.on_roller.moment, 0.0);
  EXPECT_GT(forces.on_roller.moment, -0.05 * 60.0 * 2.62e-3);
  EXPECT_GT(forces.friction_power, 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::motion::cage_pocket_test
