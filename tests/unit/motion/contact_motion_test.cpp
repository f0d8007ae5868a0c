#include "bearing/motion/contact_motion.hpp"

#include <gtest/gtest.h>

#include "bearing/geometry.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::contact_motion_test {
namespace {

constexpr double kRoundOff = 1e-12;

// A roller on its pitch circle between centred rings that turn: the formulas of plane kinematics hold.
struct CentredRings {
  double a = 2.62e-3, inner_radius = 15.2e-3, outer_radius = 20.44e-3;
  double orbit = 300.0, spin = -2100.0, inner_speed = 40.0, outer_speed = 700.0, angle = 0.7;

  BodyMotion roller() const {
    const Vector2 outward(std::cos(angle), std::sin(angle));
    return {(inner_radius + a) * outward, (inner_radius + a) * orbit * across(outward), spin};
  }
  ContactMotion on(double side) const {
    const BodyMotion ring{Vector2::Zero(), Vector2::Zero(), side < 0.0 ? inner_speed : outer_speed};
    return contact_motion(roller(), a, ring, {side, side < 0.0 ? inner_radius : outer_radius});
  }
};

TEST(ContactMotion, SlidingAndRollingOfCentredRings) {
  const CentredRings rings;
  const double own_spin = (rings.spin - rings.orbit) * rings.a;
  const double inner_surface = (rings.inner_speed - rings.orbit) * rings.inner_radius;
  const double outer_surface = (rings.outer_speed - rings.orbit) * rings.outer_radius;
  EXPECT_NEAR(rings.on(-1.0).sliding, inner_surface + own_spin, kRoundOff);
  EXPECT_NEAR(rings.on(-1.0).rolling, 0.5 * (inner_surface - own_spin), kRoundOff);
  EXPECT_NEAR(rings.on(1.0).sliding, outer_surface - own_spin, kRoundOff);
  EXPECT_NEAR(rings.on(1.0).rolling, 0.5 * (outer_surface + own_spin), kRoundOff);
  EXPECT_NEAR(rings.on(1.0).approach, 0.0, kRoundOff);
  EXPECT_NEAR(rings.on(-1.0).approach, 0.0, kRoundOff);
}

TEST(ContactMotion, PureRollingDoesNotSlide) {
  const BearingGeometry geometry = geometry_of(test::reducer_bearing());
  CentredRings rings;
  rings.orbit = kinematic_cage_speed(geometry, rings.inner_speed, rings.outer_speed);
  rings.spin = kinematic_roller_spin(geometry, rings.inner_speed, rings.outer_speed);
  EXPECT_NEAR(rings.on(1.0).sliding, 0.0, kRoundOff);
  EXPECT_NEAR(rings.on(-1.0).sliding, 0.0, kRoundOff);
}

// A roller that moves outward closes the outer gap and opens the inner one.
TEST(ContactMotion, ApproachSpeedIsTheRateOfTheApproach) {
  const CentredRings rings;
  const Vector2 outward(std::cos(rings.angle), std::sin(rings.angle));
  BodyMotion roller = rings.roller();
  roller.velocity += 0.25 * outward;
  const BodyMotion ring{Vector2::Zero(), Vector2::Zero(), 0.0};
  EXPECT_NEAR(contact_motion(roller, rings.a, ring, {1.0, rings.outer_radius}).approach_speed, 0.25,
              kRoundOff);
  EXPECT_NEAR(contact_motion(roller, rings.a, ring, {-1.0, rings.inner_radius}).approach_speed, -0.25,
              kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::motion::contact_motion_test
