// Balls where rollers are required, and rollers where balls are, are refused with what was found.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "bearing/equilibrium/aligned_pitch.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "bearing/motion/model.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::elements_test {
namespace {

Bearing of_balls(double contact_angle = 0.0) {
  return {.cage = {.inner_diameter = 40e-3, .outer_diameter = 47e-3, .width = 12e-3, .density = 8000.0},
          .elements = Balls{.count = 7, .diameter = 11.5e-3, .contact_angle = contact_angle},
          .pitch_diameter = 43.5e-3,
          .radial_clearance = 20e-6};
}

std::string refusal_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Elements, BallsAreRefusedWhereRollersAreRequired) {
  const Bearing balls = of_balls();
  const OperatingPoint point = example_bearings::static_load(100.0);
  for (const std::function<void()>& call : std::vector<std::function<void()>>{
           [&] { quasi_static_bearing(balls, point, {}); }, [&] { laminae::LaminaBearing cut(balls); },
           [&] { vectorised::AlignedPitch::of(balls, {}); }, [&] { motion::bearing_model(balls, point, {}); },
           [&] { equilibrium::RollerRow row(balls); }, [&] { rating::roller_set(balls); },
           [&] { contact_capacity(balls, Race::inner, 0.83); }})
    EXPECT_EQ(refusal_of(call),
              "rolling elements of the bearing: found balls; required: cylindrical rollers");
}

TEST(Elements, RollersAreRefusedWhereBallsAreRequired) {
  const Bearing rollers = example_bearings::bearing_209();
  for (const std::function<void()>& call : std::vector<std::function<void()>>{
           [&] { equilibrium::BallRow row(rollers); }, [&] { rating::ball_set(rollers); }})
    EXPECT_EQ(refusal_of(call),
              "rolling elements of the bearing: found cylindrical rollers; required: balls");
}

// A sphere, a ring with round pockets, and grooves: the deepest point of a groove lies on the ball's diameter
// where the contact angle is zero, else its centre follows from ball and angle.
TEST(Elements, GeometryOfBalls) {
  using constants::pi;
  const Bearing deep = of_balls();
  const BearingGeometry geometry = geometry_of(deep);
  const double ball = 7850.0 * pi / 6.0 * std::pow(11.5e-3, 3.0);
  EXPECT_NEAR(geometry.element_mass, ball * deep.material.density / 7850.0, 1e-15);
  EXPECT_NEAR(geometry.element_inertia, 0.1 * geometry.element_mass * 11.5e-3 * 11.5e-3, 1e-18);
  EXPECT_NEAR(geometry.outer_radius - geometry.inner_radius, 11.5e-3 + 10e-6, 1e-15);
  const double ring = 0.25 * pi * (47e-3 * 47e-3 - 40e-3 * 40e-3) * 12e-3;
  const double pockets = 7.0 * 0.25 * pi * 11.5e-3 * 11.5e-3 * 3.5e-3;
  EXPECT_NEAR(geometry.cage_mass, 8000.0 * (ring - pockets), 1e-12);

  const double angle = 0.4;
  const Bearing angular = of_balls(angle);
  const BearingGeometry slanted = geometry_of(angular);
  const double gamma = 11.5 * std::cos(angle) / 43.5;
  EXPECT_NEAR(slanted.slenderness, gamma, 1e-15);
  EXPECT_NEAR(kinematic_cage_speed(slanted, 100.0, 0.0), 50.0 * (1.0 - gamma), 1e-12);
  // From the pitch circle to the centre of the outer groove, and from there to its bottom.
  const double groove = 0.53 * 11.5e-3;
  const double centre = 0.5 * 43.5e-3 - (groove - 0.5 * 11.5e-3) * std::cos(angle);
  EXPECT_NEAR(slanted.outer_radius, centre + groove + 5e-6, 1e-15);
}

}  // namespace
}  // namespace orbearing::bearing::elements_test
