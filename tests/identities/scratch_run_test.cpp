// Properties of every bearing with scratches.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/geometry.hpp"
#include "coupling/analysis/scratch_run.hpp"
#include "tests/unit/defect/scratched_bearings.hpp"

namespace orbearing::analysis::scratch_run_test {
namespace {

using namespace bearing::defect;

Sampling brief(double length_error = 1e-14) {
  return {.rate = 20000.0, .revolutions = 3.0, .settling_revolutions = 0.5, .length_error = length_error};
}

double largest_difference(const RingVibration& one, const RingVibration& other) {
  return (one.position - other.position).abs().maxCoeff();
}

// A scratch of an inner race so deep in its effect that contacts open: the error follows what is allowed in a
// step, however often contacts open and balls meet edges.
TEST(ScratchRun, ErrorFollowsTheAllowedOne) {
  for (const auto& law : names_of(DampingLaw{})) {
    ScratchedBearing in = scratched(Scratched::inner);
    in.ring.damping_law = law.value;
    const RingVibration reference = sample_vibration(in, brief(1e-16));
    ASSERT_LT(reference.ball_approach.minCoeff(), 0.0);
    const double coarse = largest_difference(sample_vibration(in, brief(1e-11)), reference);
    const double fine = largest_difference(sample_vibration(in, brief(1e-13)), reference);
    EXPECT_LT(coarse, 1e-8) << law.text;
    EXPECT_GT(coarse / fine, 20.0) << law.text;  // a hundredth is allowed
  }
}

// Twice the speed, half the time; what only turns with it is the same, up to the ring's inertia.
TEST(ScratchRun, SlowlyItFollowsTheStaticBalance) {
  ScratchedBearing in = nine_balls();
  in.shaft_speed = 2.0;
  Sampling slow{.rate = 400.0, .revolutions = 2.0, .settling_revolutions = 0.0, .length_error = 1e-12};
  const RingVibration vibration = sample_vibration(in, slow);
  ASSERT_TRUE(vibration.report.completed) << vibration.report.message;
  const double cage = passing_frequencies(in.bearing, in.shaft_speed).cage;
  for (const Eigen::Index sample : {Eigen::Index{100}, Eigen::Index{333}, Eigen::Index{1200}}) {
    ScratchedBearing there = in;
    const double time = vibration.begin + static_cast<double>(sample) / slow.rate;
    there.bearing.first_element = 2.0 * 3.14159265358979324 * cage * time;
    const Eigen::Vector2d position = ScratchedMotion(there).static_position().position;
    EXPECT_NEAR(vibration.position(0, sample), position[0], 2e-4 * position[0]);
    EXPECT_NEAR(vibration.position(1, sample), position[1], 2e-4 * position[0]);
  }
}

// The mean force of the balls bears the load: the mean acceleration over whole passages vanishes.
TEST(ScratchRun, MeanForcesBalance) {
  for (const Scratched race : {Scratched::none, Scratched::outer}) {
    ScratchedBearing in = scratched(race);
    if (race == Scratched::none) in.scratch = {};
    Sampling sampling = brief();
    const double pass = passing_frequencies(in.bearing, in.shaft_speed).outer_pass;
    sampling.rate = 400.0 * pass;  // whole passages
    sampling.settling_revolutions = 3.0;
    const RingVibration vibration = sample_vibration(in, sampling);
    const Eigen::Index whole = vibration.ball_load.size() / 400 * 400;
    const Eigen::ArrayXd along = vibration.acceleration.row(0).head(whole).transpose();
    EXPECT_LT(std::abs(along.mean()) * in.ring.mass, 2e-3 * in.load);
  }
}

// The angle of the shaft is the integral of its speed, and continues at the speed of the end.
TEST(ScratchRun, AnglesOfARunUpAreTheIntegralOfItsSpeed) {
  const bearing::defect::RunUp run_up{.from = 0.3, .time = 2.0};
  EXPECT_EQ(run_up.share_at(0.0), 0.3);
  EXPECT_DOUBLE_EQ(run_up.share_at(1.0), 0.65);
  EXPECT_EQ(run_up.share_at(5.0), 1.0);
  EXPECT_DOUBLE_EQ(run_up.turned_at(2.0), 1.3);
  EXPECT_DOUBLE_EQ(run_up.turned_at(5.0), 4.3);
  for (const double now : {0.1, 0.7, 1.9, 2.4})
    EXPECT_NEAR((run_up.turned_at(now + 1e-5) - run_up.turned_at(now - 1e-5)) / 2e-5, run_up.share_at(now),
                1e-9);
  EXPECT_EQ(bearing::defect::RunUp{}.turned_at(0.123), 0.123);
}

// The requested number of revolutions, the speed of the case at the last of them; the displacement of the
// ring follows from the equations of the steady motion where the run-up begins at (nearly) all of the speed.
TEST(ScratchRun, RunsUpOverTheRevolutionsAskedFor) {
  const ScratchedBearing in = scratched(Scratched::inner);
  Sampling sampling = brief();
  sampling.run_up_from = 0.4;
  const RingVibration run_up = sample_vibration(in, sampling);
  ASSERT_TRUE(run_up.report.completed) << run_up.report.message;
  const Eigen::ArrayXd& angle = run_up.shaft_angle;
  const Eigen::Index last = angle.size() - 1;
  const double turn = 2.0 * 3.14159265358979324;
  // Less what the length that transforms fast leaves out.
  EXPECT_LT((angle[last] - angle[0]) / turn, 3.0);
  EXPECT_GT((angle[last] - angle[0]) / turn, 2.95);
  EXPECT_NEAR((angle[last] - angle[last - 1]) * sampling.rate, in.shaft_speed, 0.01 * in.shaft_speed);
  EXPECT_LT((angle[1] - angle[0]) * sampling.rate, 0.7 * in.shaft_speed);
  EXPECT_NEAR(run_up.shaft_speed, (angle[last] - angle[0]) * sampling.rate / static_cast<double>(last), 1e-9);
  EXPECT_NEAR(run_up.cage_speed / run_up.shaft_speed,
              bearing::kinematic_cage_speed(geometry_of(in.bearing), 1.0, 0.0), 1e-12);

  const RingVibration steady = sample_vibration(in, brief());
  EXPECT_EQ(steady.shaft_speed, in.shaft_speed);
  sampling.run_up_from = 1.0 - 1e-9;
  const RingVibration nearly = sample_vibration(in, sampling);
  ASSERT_EQ(nearly.ball_load.size(), steady.ball_load.size());
  EXPECT_LT(largest_difference(nearly, steady), 1e-10);
}

TEST(ScratchRun, OneScratchMoreIsMetAsOften) {
  ScratchedBearing in = scratched(Scratched::outer);
  in.scratch.more_angles = {0.3};
  const RingVibration two = sample_vibration(in, brief());
  in.scratch.more_angles.clear();
  const RingVibration one = sample_vibration(in, brief());
  ASSERT_TRUE(two.report.completed);
  EXPECT_GT(two.acceleration.row(0).square().mean(), 1.3 * one.acceleration.row(0).square().mean());
}

TEST(ScratchRun, RandomBearingsEndWithNumbers) {
  constexpr unsigned seed = 20251122;
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
  };
  for (int number = 0; number < 40; ++number) {
    ScratchedBearing in;
    const int balls = std::uniform_int_distribution<int>(5, 20)(random);
    const double diameter = between(2e-3, 50e-3);
    in.bearing.elements = bearing::Balls{.count = balls, .diameter = diameter};
    in.bearing.pitch_diameter = diameter * balls * between(0.4, 0.8);
    in.bearing.radial_clearance = std::uniform_real_distribution<double>(-1e-3, 2e-3)(random) * diameter;
    in.ring.mass = 7800.0 * std::pow(in.bearing.pitch_diameter, 2) * diameter * between(0.2, 2.0);
    in.ring.damping_ratio = between(0.005, 0.5);
    in.ring.damping_law = number % 2 == 0 ? DampingLaw::viscous : DampingLaw::hunt_crossley;
    in.load = 1e6 * diameter * diameter * between(0.5, 30.0);
    in.shaft_speed = between(1.0, 10.0) / in.bearing.pitch_diameter;  // [rad/s]
    in.scratch = {.race = names_of(Scratched{})[static_cast<std::size_t>(number) % 4].value,
                  .width = diameter * between(0.01, 0.2),
                  .depth = diameter * between(0.001, 0.1),
                  .form = names_of(bearing::ScratchForm{})[static_cast<std::size_t>(number / 4) % 4].value};
    Sampling sampling{.rate = 200.0 * in.shaft_speed / 6.28,
                      .revolutions = 2.0,
                      .settling_revolutions = 0.5,
                      .length_error = 1e-9 * diameter};
    const RingVibration vibration = sample_vibration(in, sampling);
    ASSERT_TRUE(vibration.report.completed)
        << "seed " << seed << ", number " << number << ": " << vibration.report.message;
    EXPECT_TRUE(vibration.acceleration.allFinite()) << number;
    EXPECT_GT(vibration.largest_load, 0.0) << number;
  }
}

}  // namespace
}  // namespace orbearing::analysis::scratch_run_test
