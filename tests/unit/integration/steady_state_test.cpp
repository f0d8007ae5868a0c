// When means stand still, and what becomes of the means of several bearings.
#include "coupling/integration/steady_state.hpp"

#include <gtest/gtest.h>

#include "coupling/study/two_way.hpp"

namespace orbearing::integration::steady_state_test {
namespace {

using bearing::dynamics::WindowStatistics;

constexpr double kCageSpeed = -300.0;  // [rad/s]

WindowStatistics window() {
  WindowStatistics means;
  means.inner.load_rms = 100.0;
  means.outer.load_rms = 120.0;
  means.cage_speed = -301.0;
  return means;
}

bool steady_after(double WindowStatistics::*mean, double factor) {
  WindowStatistics now = window();
  now.*mean *= factor;
  return is_steady(window(), now, kCageSpeed, {.integration = {}});
}
bool steady_after(bearing::dynamics::RaceStatistics WindowStatistics::*race, double factor) {
  WindowStatistics now = window();
  (now.*race).load_rms *= factor;
  return is_steady(window(), now, kCageSpeed, {.integration = {}});
}

// Each of the three means alone can say that it drifts, up as well as down.
TEST(Steady, AsksBothRacesAndTheCage) {
  EXPECT_TRUE(is_steady(window(), window(), kCageSpeed, {.integration = {}}));
  for (const double sign : {-1.0, 1.0}) {
    for (const auto race : {&WindowStatistics::inner, &WindowStatistics::outer}) {
      EXPECT_TRUE(steady_after(race, 1.0 + sign * 0.0015));
      EXPECT_FALSE(steady_after(race, 1.0 + sign * 0.0025));
    }
    EXPECT_TRUE(steady_after(&WindowStatistics::cage_speed, 1.0 + sign * 0.0009));
    EXPECT_FALSE(steady_after(&WindowStatistics::cage_speed, 1.0 + sign * 0.0011));
  }
}

// Three unlike bearings, the greatest and the least of all in neither the first nor the last.
TEST(Pooled, MeansAndExtremesOfSeveralBearings) {
  std::vector<WindowStatistics> bearings;
  for (const double size : {1.0, 3.0, 2.0}) {
    WindowStatistics one;
    one.samples = 10;
    one.duration = 0.1;
    for (bearing::dynamics::RaceStatistics* race : {&one.inner, &one.outer}) {
      const double of = race == &one.inner ? size : 10.0 * size;
      *race = {.roller_rms = Eigen::Array2d(of, 2.0 * of),
               .load_rms = of,
               .load_max = 5.0 * of,
               .mean_load = Eigen::Array2d(of, 0.0),
               .passages = Eigen::Array2d(0.5 * of, 1.0),
               .damage = Eigen::Array2d(of * of, 0.0),
               .mean_sliding = of,
               .least_film = 1.0 / of};
    }
    one.cage_speed = -size;
    one.mean_spin = 7.0 * size;
    one.mean_cage_eccentricity = 0.1 * size;
    one.largest_cage_eccentricity = 0.2 * size;
    one.mean_cage_position = {size, -size};
    one.bore_friction_moment = 4.0 * size;
    one.loss.drag = 6.0 * size;
    bearings.push_back(one);
  }
  constexpr double kRoundOff = 1e-13;
  const WindowStatistics all = study::pooled(bearings);
  EXPECT_EQ(all.samples, 10);
  EXPECT_EQ(all.duration, 0.1);
  const double mean_square = (1.0 + 9.0 + 4.0) / 3.0;
  for (const double scale : {1.0, 10.0}) {
    const bearing::dynamics::RaceStatistics& race = scale == 1.0 ? all.inner : all.outer;
    EXPECT_NEAR(race.roller_rms[1], scale * 2.0 * std::sqrt(mean_square), scale * kRoundOff);
    EXPECT_NEAR(race.load_rms, scale * std::sqrt(mean_square), scale * kRoundOff);
    EXPECT_EQ(race.load_max, scale * 15.0);
    EXPECT_NEAR(race.mean_load[0], scale * 2.0, scale * kRoundOff);
    EXPECT_NEAR(race.passages[0], scale * 1.0, scale * kRoundOff);
    EXPECT_NEAR(race.passages[1], 1.0, kRoundOff);
    EXPECT_NEAR(race.damage[0], scale * scale * mean_square, scale * scale * kRoundOff);
    EXPECT_NEAR(race.mean_sliding, scale * 2.0, scale * kRoundOff);
    EXPECT_EQ(race.least_film, 1.0 / (scale * 3.0));
  }
  EXPECT_NEAR(all.cage_speed, -2.0, kRoundOff);
  EXPECT_NEAR(all.mean_spin, 14.0, 10.0 * kRoundOff);
  EXPECT_NEAR(all.mean_cage_eccentricity, 0.2, kRoundOff);
  EXPECT_EQ(all.largest_cage_eccentricity, 0.2 * 3.0);
  EXPECT_NEAR(all.mean_cage_position.y(), -2.0, kRoundOff);
  EXPECT_NEAR(all.bore_friction_moment, 8.0, 10.0 * kRoundOff);
  EXPECT_NEAR(all.loss.total(), 12.0, 10.0 * kRoundOff);
}

}  // namespace
}  // namespace orbearing::integration::steady_state_test
