#include "bearing/design_problems.hpp"

#include <gmock/gmock.h>

namespace orbearing::bearing::design_problems_test {
namespace {

using mechanics::Problems;
using testing::ElementsAre;
using testing::IsEmpty;

// NU 1005 with a cage, as a planet of the reducer of [Gai2025] has it.
BearingDesign sound() {
  return {.rollers = {.count = 15, .diameter = 5.24e-3, .length = 5.7e-3},
          .pitch_diameter = 35.64e-3,
          .radial_clearance = 20e-6,
          .bore = 25e-3,
          .outside_diameter = 47e-3,
          .width = 11.9e-3,
          .cage = {.inner_diameter = 33.44e-3, .outer_diameter = 38.54e-3, .width = 9e-3, .density = 1310.0},
          .pocket_clearance = 0.1e-3,
          .guide_land = 38.85e-3};
}

std::vector<std::string> keys(const Problems& problems) {
  std::vector<std::string> keys;
  for (const mechanics::Problem& problem : problems) keys.push_back(problem.key);
  return keys;
}
template <class Change>
std::vector<std::string> keys_with(const Change& change) {
  BearingDesign design = sound();
  change(design);
  return keys(problems(design));
}

TEST(DesignProblems, AreNoneOfASoundBearing) {
  EXPECT_THAT(keys(problems(sound())), IsEmpty());
  EXPECT_THAT(keys(problems(BearingDesign{})), IsEmpty());  // nothing is stated
}

// 21.36 rollers of this diameter touch one another on the pitch circle: d_m sin(pi/z) = d.
TEST(DesignProblems, AreRollersThatDoNotFitAroundThePitchCircle) {
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.rollers.count = 22; }), ElementsAre("bearing.rollers"));
  EXPECT_THAT(
      keys_with([](BearingDesign& m) { m.rollers.count = 21; }),
      ElementsAre("bearing.cage.pocket_clearance"));  // 0.07 mm less than its play is left between them
}

TEST(DesignProblems, AreSeatsBeyondTheRaces) {
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.bore = 30.4e-3; }), ElementsAre("bearing.bore"));
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.bore = 30.38e-3; }), IsEmpty());
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.outside_diameter = 40.88e-3; }),
              ElementsAre("bearing.outside_diameter"));
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.pin_bore = 25e-3; }), ElementsAre("bearing.fit.pin_bore"));
}

// Without a ring, seat and race are one.
TEST(DesignProblems, AreNoneOfMissingRings) {
  EXPECT_THAT(keys_with([](BearingDesign& m) {
                m.bore = 30.4e-3;
                m.rings = Rings::outer;
              }),
              IsEmpty());
  EXPECT_THAT(keys_with([](BearingDesign& m) {
                m.outside_diameter = 40.88e-3;
                m.rings = Rings::none;
              }),
              IsEmpty());
}

TEST(DesignProblems, AreCagesThatReachIntoARaceOrALand) {
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.cage.inner_diameter = 30.38e-3; }),
              ElementsAre("bearing.cage.inner_diameter"));
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.cage.outer_diameter = 40.9e-3; }),
              ElementsAre("bearing.cage.outer_diameter", "bearing.cage.guide_land_diameter"));
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.guide_land = 38.54e-3; }),
              ElementsAre("bearing.cage.guide_land_diameter"));
  const auto guided_inside = [](double land) {
    return keys_with([land](BearingDesign& m) {
      m.cage.guidance = Race::inner;
      m.guide_land = land;
    });
  };
  EXPECT_THAT(guided_inside(33.5e-3), ElementsAre("bearing.cage.guide_land_diameter"));
  EXPECT_THAT(guided_inside(33.4e-3), IsEmpty());
  EXPECT_THAT(keys_with([](BearingDesign& m) {
                m.cage.outer_diameter = 40.9e-3;
                m.caged = false;
              }),
              IsEmpty());
}

TEST(DesignProblems, AreRollersLongerThanTheirRingsOrCage) {
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.rollers.length = 9.5e-3; }),
              ElementsAre("bearing.cage.width"));
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.width = 5.6e-3; }), ElementsAre("bearing.roller_length"));
  EXPECT_THAT(keys_with([](BearingDesign& m) { m.width = m.rollers.length; }), IsEmpty());
}

TEST(DesignProblems, GiveBothLengthsAndTheInputAsWritten) {
  BearingDesign design = sound();
  design.bore = 30.4e-3;
  EXPECT_EQ(problems(design).front().text,
            "'{bearing.bore}' does not fit; a bore within the inner raceway (30.4 mm) less than 30.39 mm is "
            "required");
}

// 6210: with osculations of 0.52 and 0.53 grooves take up 2 (0.52 + 0.53 - 1) d of clearance.
TEST(DesignProblems, OfBallsAreCrowdsAndOpenGrooves) {
  const BearingDesign sound{.balls = 10,
                            .ball_diameter = 12.7e-3,
                            .inner_osculation = 0.52,
                            .outer_osculation = 0.53,
                            .pitch_diameter = 70e-3,
                            .radial_clearance = 20e-6};
  EXPECT_THAT(ball_problems(sound), IsEmpty());
  BearingDesign crowded = sound;
  crowded.balls = 18;  // 17.2 touch one another
  EXPECT_THAT(keys(ball_problems(crowded)), ElementsAre("bearing.balls"));
  BearingDesign open = sound;
  open.radial_clearance = 1.28e-3;  // 2 x 0.05 x 12.7 mm
  EXPECT_THAT(keys(ball_problems(open)), ElementsAre("bearing.radial_clearance"));
  open.radial_clearance = 1.26e-3;
  EXPECT_THAT(ball_problems(open), IsEmpty());
}

// Three balls of half the pitch circle on a groove of radius f d: on the outer race the ball's curvature 2/d
// less the race's is 4/3d along the direction of rolling, and (2 - 1/f)/d across it. They are equal at f
// = 1.5.
TEST(DesignProblems, OfBallsAreEllipsesThatLieAlongTheRolling) {
  BearingDesign design{.balls = 3,
                       .ball_diameter = 10e-3,
                       .inner_osculation = 1.4,
                       .outer_osculation = 1.49,
                       .pitch_diameter = 20e-3};
  EXPECT_THAT(ball_problems(design), IsEmpty());
  design.outer_osculation = 1.51;
  ASSERT_THAT(keys(ball_problems(design)), ElementsAre("bearing.outer_osculation"));
  EXPECT_THAT(ball_problems(design).front().text, testing::HasSubstr("at most 1.5 is required"));
  design.contact_angle = 0.2;  // gamma = 0.49
  EXPECT_THAT(ball_problems(design), IsEmpty());
}

}  // namespace
}  // namespace orbearing::bearing::design_problems_test
