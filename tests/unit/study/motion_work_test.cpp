// Issue 50, Build 2: what a motion takes, known before it is computed.
#include "coupling/study/motion_work.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reducer.hpp"

namespace orbearing::study::motion_work_test {
namespace {

constexpr double kMillisecond = 1e-3, kMicrosecond = 1e-6;  // [s]

// Two runs of 10 ms a revolution with steps of 4 us, of which errors allow 2 us.
MotionWork example() {
  return {.runs = 2.0,
          .settling = 2.0,
          .turn = 10.0 * kMillisecond,
          .longest_step = 4.0 * kMicrosecond,
          .accurate_step = 2.0 * kMicrosecond,
          .step_seconds = 3.0 * kMicrosecond,
          .other_seconds = 0.5};
}

TEST(MotionWork, CountsRevolutionsOfAllRuns) {
  const MotionWindows windows{.observed = 9, .most = 20};
  // 2 + 9 in the last run; before it 2 + (3 + 9)/2.
  EXPECT_NEAR(example().time(windows), (2 + 9 + 2 + 6) * 10.0 * kMillisecond, 1e-12);
  EXPECT_NEAR(example().steps(windows), 0.19 / 2e-6, 1e-6);
  EXPECT_NEAR(example().seconds(windows), 0.19 / 2e-6 * 3e-6 + 0.5, 1e-12);
  MotionWork exchanged = example();
  exchanged.window_seconds = 20.0;
  exchanged.alike = 3;
  EXPECT_NEAR(exchanged.seconds(windows), 3 * (0.285 + 20.0 * 0.19 + 0.5), 1e-12);
  EXPECT_NEAR(seconds_of({example(), example()}, windows), 2 * 0.785, 1e-12);
}

TEST(MotionWork, BoundsOfTheWindowsCount) {
  MotionWork late = example();
  late.runs = 1.0;
  late.settling = 5.0;
  EXPECT_NEAR(late.time({.observed = 3, .most = 20}), 0.08, 1e-12);
  EXPECT_NEAR(late.time({.observed = 3, .most = 4}), 0.07, 1e-12);
  late.run_up = 0.3;
  EXPECT_NEAR(late.time({.observed = 3, .most = 20}), 0.36, 1e-12);
}

TEST(MotionWork, StepsGrowWithTheRootOfTheErrorUpToTheLongest) {
  EXPECT_NEAR(example().step({.length_error = 0.5e-10}), 1.0 * kMicrosecond, 1e-15);
  EXPECT_NEAR(example().step({.length_error = 1e-9}), 4.0 * kMicrosecond, 1e-15);
}

TEST(MotionWork, MeansOverMoreRevolutionsScatterLessByTheRoot) {
  EXPECT_NEAR(scatter_of_life({.observed = 4}) / scatter_of_life({.observed = 9}), 1.5, 1e-12);
}

NamedSet reducer_at(double speed) {
  NamedSet set{"", example::reducer(), {}};
  set.drivetrain.drive.speed = speed;
  set.drivetrain.steady_state.integration.method = integration::Method::linearly_implicit;
  set.drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  set.geometry = derive(set.drivetrain);
  return set;
}

// Counts are those of the motion, to a third: bearings under mean loads settle in two revolutions.
TEST(MotionWork, StepsAreThoseOfTheMotion) {
  NamedSet set = reducer_at(6000.0 * example::rpm);
  const MotionWindows windows{.observed = 3};
  set.drivetrain.steady_state.observed_windows = windows.observed;
  const std::vector<MotionWork> work = motion_work({set}, Fidelity::dynamic);
  ASSERT_EQ(work.size(), 1U);
  const PointResult point = evaluate({set}, Fidelity::dynamic);
  const double steps = static_cast<double>(point.dynamic->run.steps);
  EXPECT_GT(work.front().steps(windows), 0.75 * steps);
  EXPECT_LT(work.front().steps(windows), 1.33 * steps);
}

TEST(MotionWork, RevolutionsAreShorterAtHigherSpeed) {
  const double speed = 3000.0 * example::rpm;
  const MotionWork slow = motion_work({reducer_at(speed)}, Fidelity::dynamic).front(),
                   fast = motion_work({reducer_at(2.0 * speed)}, Fidelity::dynamic).front();
  EXPECT_NEAR(slow.turn / fast.turn, 2.0, 1e-9);
  const double ratio = slow.seconds({}) / fast.seconds({});  // of estimates, which no clock has
  EXPECT_GT(ratio, 1.5);
}

}  // namespace
}  // namespace orbearing::study::motion_work_test
