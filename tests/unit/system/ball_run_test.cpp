// Drives of the rings, settling of a slip, refusals and means of a run of balls.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/life/standard_life.hpp"
#include "coupling/system/ball_run.hpp"
#include "coupling/system/balls_in_time.hpp"
#include "tests/messages.hpp"
#include "tests/unit/system/small_ball_bearing.hpp"

namespace orbearing::system::ball_run_test {
namespace {

using bearing::balls::BallDuty;
using bearing::balls::RingDrive;

TEST(RingDrive, SpeedsUpThenKeepsItsSpeed) {
  const RingDrive drive{0.0, 500.0, 200.0};
  EXPECT_DOUBLE_EQ(drive.duration(), 0.4);
  EXPECT_DOUBLE_EQ(drive.speed_at(0.1), 50.0);
  EXPECT_DOUBLE_EQ(drive.speed_at(0.5), 200.0);
  EXPECT_DOUBLE_EQ(drive.angle_at(0.4), 40.0);
  EXPECT_DOUBLE_EQ(drive.angle_at(1.4), 240.0);
  EXPECT_DOUBLE_EQ(drive.acceleration_at(0.39), 500.0);
  EXPECT_DOUBLE_EQ(drive.acceleration_at(0.41), 0.0);
  EXPECT_DOUBLE_EQ(RingDrive::steady(-3.0).angle_at(2.0), -6.0);
}

// A signal with known settling time: 0.01 + exp(-t/tau) cos(2 pi f t), sampled every 10 us. It last leaves
// 0.01 +- 0.05 between the envelope's crossing, tau ln 20, and half a period before: at an extreme of the
// cosine.
SlipHistory decaying(double tau, double frequency, double end, double ripple = 0.0) {
  SlipHistory history;
  const long samples = std::lround(end / 10e-6);
  for (long i = 0; i <= samples; ++i) {
    const double time = 10e-6 * static_cast<double>(i);
    history.time.push_back(time);
    history.slip.push_back(0.01 + std::exp(-time / tau) * std::cos(2.0 * M_PI * frequency * time) +
                           ripple * std::sin(2.0 * M_PI * 700.0 * time));
  }
  return history;
}

TEST(SettlingTime, IsWhereADecayingSlipLastLeavesItsBand) {
  constexpr double tau = 1e-3, sampled = 2e-8;  // [s]; straight lines between samples: h^2/8 of the curvature
  EXPECT_NEAR(*settling_time(decaying(tau, 0.0, 0.06), 0.06, 0.05), tau * std::log(20.0), sampled);
  EXPECT_NEAR(*settling_time(decaying(tau, 0.0, 0.06), 0.06, 0.2), tau * std::log(5.0), sampled);
  // The last extreme of a cosine of 1 kHz outside +-0.06 is that near 2.5 ms, -0.083; the next, near 3 ms, is
  // 0.050.
  const double settled = *settling_time(decaying(tau, 1000.0, 0.06), 0.06, 0.06);
  EXPECT_NEAR(std::exp(-settled / tau) * std::cos(2.0 * M_PI * 1000.0 * settled), -0.06, 1e-4);
  EXPECT_GT(settled, 2.4e-3);
  EXPECT_LT(settled, 2.75e-3);
}

TEST(SettlingTime, IsNotThatOfAMotionWithinItsBand) {
  // A cage that moves on by 4 % of its speed has settled, by 6 % not.
  const double alone = *settling_time(decaying(1e-3, 0.0, 0.06), 0.06, 0.05);
  EXPECT_NEAR(*settling_time(decaying(1e-3, 0.0, 0.06, 0.04), 0.06, 0.05), alone, 2e-3);
  EXPECT_FALSE(settling_time(decaying(1e-3, 0.0, 0.06, 0.06), 0.06, 0.05).has_value());
}

TEST(SettlingTime, GoesByTheMeanOfTheLastThirdAndIsNoneThere) {
  const auto settled = [](std::vector<double> slip) {
    return settling_time({{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, std::move(slip)}, 9.0, 0.05);
  };
  EXPECT_DOUBLE_EQ(*settled({0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4}), 0.0);
  // Mean 0.2 of the last three intervals: from 0.4 to 0.2 the band's edge, 0.25, is three quarters of a step off.
  EXPECT_DOUBLE_EQ(*settled({1.0, 0.2, 0.2, 0.4, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2}), 3.75);
  EXPECT_DOUBLE_EQ(*settled({0.2, 0.0, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2}), 1.75);
  EXPECT_FALSE(settled({0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.3, 0.2, 0.2}).has_value());
  EXPECT_FALSE(settling_time({{}, {}}, 9.0, 0.05).has_value());  // an outer ring that stands and one that does not turn
}

// Parts 1 to 10: variance of one 55/6, of their mean 11/12; Student's t of nine degrees of freedom 2.262157.
TEST(ErrorOfMean, IsThatOfStudentsT) {
  EXPECT_NEAR(error_of_mean({3.0, 1.0, 2.0, 10.0, 4.0, 5.0, 9.0, 6.0, 7.0, 8.0}), 2.262157163 * std::sqrt(11.0 / 12.0), 1e-8);
  EXPECT_EQ(error_of_mean({2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0}), 0.0);
}

BallRunResult run(double load, double speed, const BallRunOptions& options, double clearance = 20e-6) {
  const bearing::Bearing b = small_ball_bearing(clearance);
  BallDuty duty;
  duty.inner = RingDrive::steady(speed);
  duty.on_inner = {{load, 0.0, 0.0, 0.0, 0.0}};
  return run_balls(b, small_ball_motion(), duty, bearing::rating::ratings_of(b, {}).contacts, options);
}

BallRunOptions short_run() {
  BallRunOptions options;
  options.duration = 0.02;
  options.observed = 0.5;
  options.samples = 40;
  return options;
}

TEST(BallRun, SamplesWhereItSaysAndBalancesTheLoad) {
  BallRunOptions options = short_run();
  options.duration = 0.2;
  options.samples = 4000;
  const BallRunResult result = run(500.0, 300.0, options);
  ASSERT_TRUE(result.completed) << result.message;
  ASSERT_EQ(result.series.time.size(), 4001u);
  EXPECT_NEAR(result.series.time[1000], 0.05, 1e-12);
  EXPECT_NEAR(result.means.cage_slip, 0.0, 0.05);
  EXPECT_GT(result.means.loss.total(), 0.0);
  EXPECT_GT(result.means.life.bearing, 0.0);
}

// The drive gives the losses. Its torque jumps with impacts: the mean over states is that of the losses in
// fine steps alone.
TEST(BallRun, TheDriveGivesWhatIsLost) {
  BallRunOptions options = short_run();
  options.duration = 0.4;
  const double friction = run(500.0, 300.0, options).means.friction_torque;
  options.samples = 80000;
  options.length_error *= 0.1;
  const BallRunResult fine = run(500.0, 300.0, options);
  double torque = 0.0;
  const std::size_t first = fine.series.torque.size() / 2;
  for (std::size_t i = first; i < fine.series.torque.size(); ++i)
    torque += fine.series.torque[i] / static_cast<double>(fine.series.torque.size() - first);
  EXPECT_NEAR(torque / friction, 1.0, 0.03);
  EXPECT_NEAR(fine.means.friction_torque / friction, 1.0, 0.01);
}

// Under an axial load balls press on both races at the angle of the static equilibrium, where they hardly
// rotate.
TEST(BallRun, ContactAnglesOfBothRacesAreThoseOfTheStaticBalance) {
  const bearing::Bearing b = small_ball_bearing(20e-6);
  BallDuty duty;
  duty.inner = RingDrive::steady(20.0);
  duty.on_inner = {{0.0, 0.0, 800.0, 0.0, 0.0}};
  const BallMeans found =
      run_balls(b, small_ball_motion(), duty, bearing::rating::ratings_of(b, {}).contacts, short_run()).means;
  const double at_rest =
      bearing::equilibrium::balance_bearing(b, {.axial = 800.0}).contact_angle.mean();
  EXPECT_NEAR(std::abs(found.inner_angle), std::abs(at_rest), 0.02 * std::abs(at_rest));
  EXPECT_NEAR(std::abs(found.outer_angle), std::abs(at_rest), 0.02 * std::abs(at_rest));
}

TEST(BallRun, MoreLoadIsLessLifeByItsCube) {
  BallRunOptions options = short_run();
  options.duration = 0.1;
  const double light = run(1000.0, 200.0, options, 0.0).means.life.bearing;
  const double heavy = run(2000.0, 200.0, options, 0.0).means.life.bearing;
  EXPECT_NEAR(std::log2(light / heavy), 3.0, 0.1);
}

TEST(BallRun, AFinerErrorChangesLittle) {
  BallRunOptions options = short_run(), finer = options;
  finer.length_error = 0.1 * options.length_error;
  const BallRunResult coarse = run(800.0, 400.0, options), fine = run(800.0, 400.0, finer);
  EXPECT_GT(fine.report.steps, coarse.report.steps);
  EXPECT_NEAR(coarse.means.inner_load_rms / fine.means.inner_load_rms, 1.0, 0.01);
}

// The form of [Chen2026], whose positions follow from equilibrium, gives the same statistics.
TEST(BallRun, PrintedFormGivesTheStatisticsOfTheCompleteOne) {
  BallRunOptions options = short_run(), published = options;
  options.duration = published.duration = 0.03;
  published.form = BallForm::published;
  published.published_step = 2e-6;
  const BallRunResult complete = run(938.0, 181.0, options), found = run(938.0, 181.0, published);
  ASSERT_TRUE(found.completed) << found.message;
  EXPECT_NEAR(found.means.inner_load_rms / complete.means.inner_load_rms, 1.0, 0.01);
  EXPECT_NEAR(found.means.outer_load_rms / complete.means.outer_load_rms, 1.0, 0.01);
  EXPECT_NEAR(found.means.cage_speed / complete.means.cage_speed, 1.0, 0.005);
  EXPECT_NEAR(found.means.loss.total() / complete.means.loss.total(), 1.0, 0.1);
  EXPECT_NEAR(found.means.life.bearing / complete.means.life.bearing, 1.0, 0.03);
}

TEST(BallRun, PrintedFormsStepsConverge) {
  BallRunOptions coarse = short_run();
  coarse.form = BallForm::published;
  coarse.duration = 0.002;
  coarse.published_step = 4e-6;
  BallRunOptions fine = coarse;
  fine.published_step = 1e-6;
  const BallRunResult a = run(938.0, 181.0, coarse), b = run(938.0, 181.0, fine);
  EXPECT_NEAR(a.series.cage_speed.back() / b.series.cage_speed.back(), 1.0, 1e-5);
  EXPECT_NEAR(a.series.first_inner.back(), b.series.first_inner.back(), 1e-3 * 938.0);
}

// Balls that may fail too shorten the life, by less than they halve it.
TEST(BallRun, BallsShareTheLife) {
  BallRunOptions options = short_run();
  options.duration = 0.05;
  const BallMeans means = run(1000.0, 200.0, options).means;
  EXPECT_GT(means.balls_life, 0.0);
  EXPECT_GT(means.balls_life, 0.2 * means.life.bearing);
}

TEST(BallRun, RefusesWhatHasNoMeaning) {
  BallRunOptions options = short_run();
  options.duration = 0.0;
  EXPECT_REFUSED(std::invalid_argument, "ball_run 1", run(500.0, 300.0, options));
  options = short_run();
  options.observed = 1.5;
  EXPECT_REFUSED(std::invalid_argument, "ball_run 2", run(500.0, 300.0, options));
  EXPECT_REFUSED(std::invalid_argument, "ball_run 3",
                 bearing::balls::ball_numbers(bearing::Bearing{}, small_ball_motion()));
}

// Balls may be up to a radius off their circle and a diameter along the axis, the cage a radius aside.
TEST(BallsInPlace, AreBetweenTheRacesAndTheCageAboutThem) {
  const bearing::Bearing b = small_ball_bearing(20e-6);
  const bearing::balls::BallNumbers numbers = bearing::balls::ball_numbers(b, small_ball_motion());
  const bearing::balls::BallBearing model(numbers, {});
  const std::vector<double> start = bearing::balls::start_state(b, model, 0.0);
  const auto in_place = [&](std::size_t at, double length) {
    std::vector<double> x = start;
    x[at] += length;
    try {
      require_containment(numbers, x.data());
    } catch (const std::runtime_error&) {
      return false;
    }
    return true;
  };
  const auto along = static_cast<std::size_t>(2 * model.layout().lanes()),
             cage = static_cast<std::size_t>(model.layout().cage());
  const double radius = 4.76e-3;
  for (const double side : {-1.0, 1.0})
    for (std::size_t ball = 0; ball < 7; ++ball) {
      EXPECT_TRUE(in_place(ball, 0.98 * side * radius));
      EXPECT_FALSE(in_place(ball, 1.02 * side * radius));
      EXPECT_TRUE(in_place(along + ball, 1.98 * side * radius));
      EXPECT_FALSE(in_place(along + ball, 2.02 * side * radius));
    }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(in_place(cage + i, 0.9 * radius));
    EXPECT_FALSE(in_place(cage + i, 1.1 * radius));
  }
}

}  // namespace
}  // namespace orbearing::system::ball_run_test
