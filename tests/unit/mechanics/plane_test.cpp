#include "mechanics/constants.hpp"
#include "mechanics/plane.hpp"

#include <gtest/gtest.h>


namespace orbearing::mechanics::plane_test {
namespace {

constexpr double kRoundOff = 1e-15;
constexpr double kQuarter = constants::half_pi;

TEST(Plane, DirectionsTurnFromXTowardsY) {
  EXPECT_NEAR((direction(0.0) - Vector2(1.0, 0.0)).norm(), 0.0, kRoundOff);
  EXPECT_NEAR((direction(kQuarter) - Vector2(0.0, 1.0)).norm(), 0.0, kRoundOff);
  EXPECT_NEAR((direction(-kQuarter / 3.0) - Vector2(std::sqrt(3.0) / 2.0, -0.5)).norm(), 0.0, kRoundOff);
}

TEST(Plane, AcrossIsAQuarterTurnAhead) {
  for (const double angle : {0.0, 0.7, 2.0, 4.0, -1.0})
    EXPECT_NEAR((across(direction(angle)) - direction(angle + kQuarter)).norm(), 0.0, kRoundOff);
}

TEST(Plane, CrossIsTheLeverTimesTheForceAheadOfIt) {
  const Vector2 arm(3.0, 4.0);
  EXPECT_DOUBLE_EQ(cross(arm, 2.0 * across(arm)), 2.0 * 25.0);
  EXPECT_DOUBLE_EQ(cross(arm, -6.0 * arm), 0.0);
}

// A couple: no force, and the moment of one force at the distance of both.
TEST(Plane, WrenchesOfTwoForcesAddUp) {
  Wrench sum = force_at({0.0, 2.0}, {5.0, 0.0});
  sum += force_at({0.0, -2.0}, {-5.0, 0.0});
  EXPECT_EQ(sum.force, Vector2(0.0, 0.0));
  EXPECT_DOUBLE_EQ(sum.moment, -2.0 * 2.0 * 5.0);
}

}  // namespace
}  // namespace orbearing::mechanics::plane_test
