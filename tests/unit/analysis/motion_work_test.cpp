// Computing time of a motion, estimated before it is computed.
#include "coupling/analysis/motion_work.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/coupled_reducer.hpp"

namespace orbearing::analysis::motion_work_test {
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

TEST(MotionWork, IsKnownAsWellAsTheWorstOfItsMotions) {
  MotionWork slow = example();
  slow.accuracy = kAccuracyOfSlow;
  EXPECT_EQ(accuracy_of({example(), example()}), kAccuracy);
  EXPECT_EQ(accuracy_of({example(), slow, example()}), kAccuracyOfSlow);
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

// No law gives the number of steps of slow motion, which it is below 425 rpm.
TEST(MotionWork, StepsOfSlowMotionAreCounted) {
  NamedSet set = reducer_at(200.0 * example::rpm);
  const MotionWindows windows{.observed = 1, .most = 2};
  set.drivetrain.steady_state.observed_windows = windows.observed;
  set.drivetrain.steady_state.most_windows = windows.most;
  const MotionWork work = motion_work({set}, Fidelity::dynamic).front();
  EXPECT_TRUE(work.slow);
  EXPECT_EQ(work.accuracy, kAccuracyOfSlow);
  const double steps = static_cast<double>(evaluate({set}, Fidelity::dynamic).dynamic->run.steps);
  EXPECT_GT(work.steps(windows), 0.67 * steps);
  EXPECT_LT(work.steps(windows), 1.5 * steps);
}

TEST(MotionWork, OfSlowRollersThatStrikeEachOtherIsTheLeastAccurate) {
  NamedSet set = reducer_at(200.0 * example::rpm);
  set.drivetrain.bearing.cage = {};
  EXPECT_EQ(motion_work({set}, Fidelity::dynamic).front().accuracy, kAccuracyOfSlowUncaged);
  set.drivetrain.drive.speed = 6000.0 * example::rpm;
  EXPECT_EQ(motion_work({set}, Fidelity::dynamic).front().accuracy, kAccuracy);
}

TEST(MotionWork, RevolutionsAreShorterAtHigherSpeed) {
  const double speed = 3000.0 * example::rpm;
  const MotionWork slow = motion_work({reducer_at(speed)}, Fidelity::dynamic).front(),
                   fast = motion_work({reducer_at(2.0 * speed)}, Fidelity::dynamic).front();
  EXPECT_NEAR(slow.turn / fast.turn, 2.0, 1e-9);
  const double ratio = slow.seconds({}) / fast.seconds({});  // of estimates, which no clock has
  EXPECT_GT(ratio, 1.5);
}

// The reducer with its gears, of which the meshes shake the planets, where teeth of the sun mesh as often as
// `frequency` [Hz]: turns of the sun against the carrier are z_r/(z_s + z_r) of its own.
NamedSet geared_at(double frequency) {
  static const gearset::dynamics::SetParameters gears = example::reducer_gears(example::reducer());
  NamedSet set = reducer_at(2.0 * M_PI * frequency * (37.0 + 79.0) / (37.0 * 79.0));
  set.drivetrain.gear_set = [] { return gears; };
  return set;
}

MotionWork work_of(const NamedSet& set, Fidelity fidelity = Fidelity::dynamic) {
  const std::vector<MotionWork> work = motion_work({set}, fidelity);
  EXPECT_EQ(work.size(), 1U);
  return work.front();
}

// [N/m]  of steel rollers 5.7 mm long at an approach of 1 um, after Palmgren: Q = 8.06e4 l^(8/9) d^(10/9), N
// and mm.
double stiffness_of_contact() {
  return 8.06e4 * std::pow(5.7, 8.0 / 9.0) * std::pow(1e-3, 10.0 / 9.0) / 1e-6;
}

// [Hz]  of half of the planet on a quarter of 15 rollers.
double ring_frequency() {
  const NamedSet set = reducer_at(600.0);
  const double mass = 0.5 * set.geometry.planet_mass;
  return std::sqrt(0.25 * 15.0 * stiffness_of_contact() / mass) / (2.0 * M_PI);
}

// docs/motion_time.md: 2.5 runs up to 0.13 of the ring's frequency, 4.7 from 0.27 on, in a straight line
// between; helical teeth begin with 1.5. Gears take 0.02 s in each.
TEST(MotionWork, RunsOfGearsAndBearingAreThoseOfTheirFrequencies) {
  struct Row {
    double passage, straight, helical;
  };
  for (const Row& row : {Row{0.05, 2.5, 1.5}, Row{0.13, 2.5, 1.5}, Row{0.2, 3.6, 3.1}, Row{0.27, 4.7, 4.7},
                         Row{0.6, 4.7, 4.7}}) {
    NamedSet set = geared_at(row.passage * ring_frequency());
    const MotionWork straight = work_of(set);
    EXPECT_NEAR(straight.runs, row.straight, 2e-3) << row.passage;
    EXPECT_NEAR(straight.other_seconds, 0.02 * straight.runs, 1e-12);
    set.drivetrain.set.helix_angle = 0.1;
    EXPECT_NEAR(work_of(set).runs, row.helical, 0.1) << row.passage;  // a little wider, and so heavier
  }
  EXPECT_EQ(work_of(geared_at(0.01 * ring_frequency())).runs, 1.3);  // slow motion
  NamedSet mean = geared_at(0.2 * ring_frequency());
  mean.drivetrain.mesh_variation = false;
  EXPECT_EQ(work_of(mean).runs, 1.0);
  EXPECT_EQ(work_of(mean).other_seconds, 0.0);
}

constexpr double kSixteenLanes = 1.1e-6 + 16 * 0.166e-6;  // [s]  of 15 rollers

// 1.1 us and 0.166 us for each of the lanes, by which rollers go eight together; 3.6 ns more for a lamina of
// each, 13 ns where rollers tilt; 1.17 times as long where rollers bounce, 15 times by dopri5.
TEST(MotionWork, StepsTakeTheTimeOfTheirParts) {
  NamedSet set = geared_at(800.0);
  EXPECT_NEAR(work_of(set).step_seconds / (1.17 * kSixteenLanes), 1.0, 1e-12);
  set.drivetrain.mesh_variation = false;
  EXPECT_NEAR(work_of(set).step_seconds / kSixteenLanes, 1.0, 1e-12);
  set.drivetrain.bearing.rollers().laminae = 20;
  EXPECT_NEAR(work_of(set).step_seconds / (kSixteenLanes + 16 * 20 * 3.6e-9), 1.0, 1e-12);
  set.drivetrain.misalignment.planet_tilt = 1e-4;
  EXPECT_NEAR(work_of(set).step_seconds / (kSixteenLanes + 16 * 20 * 13e-9), 1.0, 1e-12);
  set = geared_at(800.0);
  set.drivetrain.mesh_variation = false;
  set.drivetrain.bearing.rollers().count = 17;
  EXPECT_NEAR(work_of(set).step_seconds / (1.1e-6 + 24 * 0.166e-6), 1.0, 1e-12);
  set.drivetrain.steady_state.integration.method = integration::Method::dopri5;
  EXPECT_NEAR(work_of(set).step_seconds / (15.0 * (1.1e-6 + 24 * 0.166e-6)), 1.0, 1e-12);
}

// Frequency of the roller between its races, and of the pocket that it strikes.
TEST(MotionWork, StepsOfBouncingRollersAreThoseOfTheirFrequency) {
  NamedSet set = geared_at(800.0);
  const double mass = set.geometry.bearing.element_mass;
  const double accurate = 1.45 / std::sqrt(2.0 * stiffness_of_contact() / mass);
  EXPECT_NEAR(work_of(set).accurate_step / accurate, 1.0, 2e-3);
  const double longest = work_of(set).longest_step / 0.97;
  set.drivetrain.set.helix_angle = 0.1;  // does not let rollers bounce
  EXPECT_NEAR(work_of(set).longest_step / (0.83 * longest), 1.0, 1e-12);
  EXPECT_TRUE(std::isinf(work_of(set).accurate_step));
}

// All 8 bearings step, 1.4 times as long; 16 steps of a mesh period end at jumps of its stiffness. Of a
// co-simulation each pass of a window takes a step of each, half a step for its end, and 15 us.
TEST(MotionWork, OfAllBearingsTogetherCountsThemAndTheirExchanges) {
  NamedSet set = geared_at(800.0);
  const MotionWork one = work_of(set), all = work_of(set, Fidelity::monolithic);
  EXPECT_NEAR(all.step_seconds / (8 * 1.4 * one.step_seconds), 1.0, 1e-12);
  EXPECT_NEAR(1.0 / all.longest_step, 1.0 / one.longest_step + 16 * 800.0, 1e-6 / one.longest_step);
  EXPECT_EQ(all.runs, 1.0);
  EXPECT_EQ(all.alike, 1);
  EXPECT_EQ(all.window_seconds, 0.0);
  set.drivetrain.exchange.window = 4e-6;
  set.drivetrain.exchange.iteration.most_passes = 3;
  const MotionWork exchanged = work_of(set, Fidelity::co_simulated);
  EXPECT_NEAR(exchanged.step_seconds / (3 * 8 * one.step_seconds), 1.0, 1e-12);
  EXPECT_NEAR(exchanged.window_seconds * 0.82 * 4e-6, 3 * 15e-6 + 0.5 * exchanged.step_seconds, 1e-12);
  EXPECT_EQ(exchanged.longest_step, one.longest_step);
  set.drivetrain.mesh_variation = false;
  EXPECT_EQ(work_of(set, Fidelity::monolithic).longest_step, work_of(set).longest_step);
}

// Two bearings one by one where their tilt is computed; a run-up takes its own time.
TEST(MotionWork, CountsWhatFollowsOneAfterTheOther) {
  NamedSet set = geared_at(800.0);
  EXPECT_EQ(work_of(set).alike, 1);
  set.drivetrain.seats.tilt = TiltState::computed;
  set.drivetrain.bearing.rollers().laminae = 10;
  EXPECT_EQ(work_of(set).alike, 2);
  set = geared_at(800.0);
  set.drivetrain.run_up = {.acceleration = 400.0, .duration = 0.07};
  EXPECT_EQ(work_of(set).run_up, 0.07);
  EXPECT_EQ(work_of(set).runs, 1.0);
}

}  // namespace
}  // namespace orbearing::analysis::motion_work_test
