#include <gtest/gtest.h>

#include "bearing/contact/pocket_law.hpp"

namespace orbearing::bearing::cage_pocket_test {
namespace {

constexpr double kRoundOff = 1e-12, kRadius = 2.62e-3, kPitchRadius = 17.82e-3;  // [-], [m], [m]

const PocketLaw kPocket{.half_clearance = 0.05e-3, .stiffness = 3e7, .damping = 1.0, .friction = {0.05, 0.1}};

PocketMotion<double, double, double, double, double, double> roller_off_by(double offset, double spin = 0.0) {
  return {offset, kPitchRadius, 0.0, 0.0, spin, 0.0};
}

TEST(CagePocket, LeavesTheRollerFreeWithinItsClearance) {
  EXPECT_LT(kPocket.depth(1.0, 0.049e-3, 0.0), 0.0);
  EXPECT_LT(kPocket.depth(-1.0, -0.049e-3, 0.0), 0.0);
}

//  cage o-------( roller )|bar|   2 um into the bar ahead: 60 N back on the roller, ahead on the cage at its
//  radius
TEST(CagePocket, PushesRollerAndCageApart) {
  const auto touch = kPocket.touch(1.0, kRadius, 0.0, roller_off_by(0.052e-3));
  const double load = 3e7 * 2e-6;
  EXPECT_NEAR(touch.ahead, -load, kRoundOff * load);
  EXPECT_NEAR(touch.cage_moment, kPitchRadius * load, kRoundOff * load);
  EXPECT_NEAR(kPocket.touch(-1.0, kRadius, 0.0, roller_off_by(-0.052e-3)).ahead, load, kRoundOff * load);
}

TEST(CagePocket, FrictionBrakesTheSpinOfTheRoller) {
  const auto touch = kPocket.touch(1.0, kRadius, 0.0, roller_off_by(0.052e-3, 3000.0));
  EXPECT_LT(touch.roller_moment, 0.0);
  EXPECT_GT(touch.roller_moment, -0.05 * 60.0 * kRadius);
  EXPECT_GT(touch.along * touch.sliding, 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::cage_pocket_test
