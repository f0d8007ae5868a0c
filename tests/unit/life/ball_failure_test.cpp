// Life with the balls' own failure, Eq. (35) of [Chen2026].
#include "bearing/life/ball_capacity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/geometry.hpp"

namespace orbearing::bearing::rating::ball_failure_test {
namespace {

constexpr double kSlope = 10.0 / 9.0;

Bearing motor() {
  Bearing b;
  b.elements = Balls{7, 9.52e-3, 0.0};
  b.pitch_diameter = 36e-3;
  return b;
}

// A ball with the track of the race (d_m = D (1 + gamma) is no bearing, so lengths are put back by hand) that
// is met as often as the race bears as long as it.
TEST(BallFailure, BallBearsTheCyclesOfTheRaceByTheLengthOfItsTrack) {
  const Bearing b = motor();
  const double gamma = 9.52 / 36.0, load = 800.0;
  const ContactCapacities one_race{.inner = 3000.0, .outer = 1e12};
  const double revolutions = life_of_balls(b, one_race, {.inner = load, .outer = 0.0});
  const double cycles_of_race = 1e6 * std::pow(3000.0 / load, 3) * 3.5 * (1.0 + gamma);
  const double cycles_of_ball =
      revolutions * std::pow(7.0, 1.0 / kSlope) * (1.0 - gamma * gamma) / (2.0 * gamma);
  EXPECT_NEAR(cycles_of_ball / cycles_of_race, std::pow(36.0 * (1.0 - gamma) / 9.52, 0.9), 1e-12);
}

TEST(BallFailure, LifeFallsWithTheCubeOfTheLoadAndMoreBallsFailSooner) {
  const ContactCapacities capacities{.inner = 3000.0, .outer = 4000.0};
  const double once = life_of_balls(motor(), capacities, {500.0, 500.0});
  EXPECT_NEAR(life_of_balls(motor(), capacities, {1000.0, 1000.0}) / once, 0.125, 1e-12);
  EXPECT_LT(once, life_of_balls(motor(), capacities, {500.0, 0.0}));
  EXPECT_TRUE(std::isinf(life_of_balls(motor(), capacities, {0.0, 0.0})));
}

TEST(BallFailure, NeitherPartMayFail) {
  EXPECT_NEAR(life_of_both(10.0, 10.0), 10.0 * std::pow(2.0, -0.9), 1e-12);
  EXPECT_NEAR(std::pow(life_of_both(3.0, 7.0), -kSlope), std::pow(3.0, -kSlope) + std::pow(7.0, -kSlope),
              1e-14);
  EXPECT_EQ(life_of_both(5.0, INFINITY), 5.0);
  EXPECT_EQ(life_of_both(INFINITY, 5.0), 5.0);
}

}  // namespace
}  // namespace orbearing::bearing::rating::ball_failure_test
