// Steady means, and the means of several bearings: one criterion for the free bearing, the driven one and one
// system.
#include "coupling/system/steady_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace orbearing::system::steady_state_test {
namespace {

using bearing::motion::WindowStatistics;

constexpr double kCageSpeed = -300.0;  // [rad/s]

WindowStatistics window() {
  WindowStatistics means;
  means.inner.load_rms = 100.0;
  means.outer.load_rms = 120.0;
  means.orbit_speed = -301.0;
  return means;
}

bool steady_after(double WindowStatistics::*mean, double factor) {
  WindowStatistics now = window();
  now.*mean *= factor;
  return is_steady(window(), now, kCageSpeed, {.integration = {}});
}
bool steady_after(bearing::motion::RaceStatistics WindowStatistics::*race, double factor) {
  WindowStatistics now = window();
  (now.*race).load_rms *= factor;
  return is_steady(window(), now, kCageSpeed, {.integration = {}});
}

// Drift of any one of the three means is detected, up as well as down.
TEST(Steady, AsksBothRacesAndTheCage) {
  EXPECT_TRUE(is_steady(window(), window(), kCageSpeed, {.integration = {}}));
  for (const double sign : {-1.0, 1.0}) {
    for (const auto race : {&WindowStatistics::inner, &WindowStatistics::outer}) {
      EXPECT_TRUE(steady_after(race, 1.0 + sign * 0.0015));
      EXPECT_FALSE(steady_after(race, 1.0 + sign * 0.0025));
    }
    EXPECT_TRUE(steady_after(&WindowStatistics::orbit_speed, 1.0 + sign * 0.0009));
    EXPECT_FALSE(steady_after(&WindowStatistics::orbit_speed, 1.0 + sign * 0.0011));
  }
}

// Three different bearings, the greatest and the least of all in neither the first nor the last.
TEST(Pooled, MeansAndExtremesOfSeveralBearings) {
  std::vector<WindowStatistics> bearings;
  for (const double size : {1.0, 3.0, 2.0}) {
    WindowStatistics one;
    one.samples = 10;
    one.duration = 0.1;
    for (bearing::motion::RaceStatistics* race : {&one.inner, &one.outer}) {
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
    one.orbit_speed = -size;
    one.mean_spin = 7.0 * size;
    one.mean_cage_eccentricity = 0.1 * size;
    one.largest_cage_eccentricity = 0.2 * size;
    one.mean_cage_position = {size, -size};
    one.bore_friction_moment = 4.0 * size;
    one.loss.drag = 6.0 * size;
    bearings.push_back(one);
  }
  constexpr double kRoundOff = 1e-13;
  const WindowStatistics all = pooled(bearings);
  EXPECT_EQ(all.samples, 10);
  EXPECT_EQ(all.duration, 0.1);
  const double mean_square = (1.0 + 9.0 + 4.0) / 3.0;
  for (const double scale : {1.0, 10.0}) {
    const bearing::motion::RaceStatistics& race = scale == 1.0 ? all.inner : all.outer;
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
  EXPECT_NEAR(all.orbit_speed, -2.0, kRoundOff);
  EXPECT_NEAR(all.mean_spin, 14.0, 10.0 * kRoundOff);
  EXPECT_NEAR(all.mean_cage_eccentricity, 0.2, kRoundOff);
  EXPECT_EQ(all.largest_cage_eccentricity, 0.2 * 3.0);
  EXPECT_NEAR(all.mean_cage_position.y(), -2.0, kRoundOff);
  EXPECT_NEAR(all.bore_friction_moment, 8.0, 10.0 * kRoundOff);
  EXPECT_NEAR(all.loss.total(), 12.0, 10.0 * kRoundOff);
}

// Two bearings under constant loads, whose cages run at a share of the kinematic speed.
class EvenMotion : public Motion {
 public:
  double share = 1.0;  // [-]  of the kinematic cage speed
  bool one_interval = true;
  double fails_at = 1e300;     // [s]
  std::vector<double> times;   // [s]  all that were shown
  std::vector<double> begins;  // [s]  of the calls of advance()

  int bearings() const override { return 2; }
  bool keeps_to_interval() const override { return one_interval; }
  void observe_steps(const StepObservers& observers) override { observers_ = observers; }
  void advance(const integration::OutputTimes& output,
               const std::function<void(double time)>& observe) override {
    begins.push_back(output.time(0));
    for (long i = 1; i <= output.samples; ++i) {
      now_ = output.time(i);
      if (now_ > fails_at) throw std::runtime_error("it failed");
      bearing::motion::Snapshot now;
      for (int b = 0; b < bearings(); ++b) {
        EvenMotion::take_snapshot(b, now);
        observers_.loads[static_cast<std::size_t>(b)]->add_loads(1.0, loads_of(now));
      }
      times.push_back(now_);
      observe(now_);
    }
  }
  void take_snapshot(int b, bearing::motion::Snapshot& into) const override {
    const Eigen::ArrayXd some = Eigen::Array3d(1.0, 2.0, 3.0);
    into.angle = into.orbital_speed = into.spin = into.pocket_load = some;
    for (bearing::motion::RaceSnapshot* race : {&into.inner, &into.outer}) {
      race->load = (b + 1.0) * some;
      race->sliding = race->entrainment = race->least_film = some;
    }
    into.orbit_speed = share * kCageSpeed;
    into.orbit_angle = into.orbit_speed * now_;
    into.race_speeds = {0.0, 2.0 * kCageSpeed, kCageSpeed};
  }
  integration::IntegrationReport report() const override { return {.steps = 7}; }

 protected:
  double now() const { return now_; }

 private:
  StepObservers observers_;
  double now_ = 0.0;  // [s]
};

constexpr double kRevolution = 2.0 * M_PI / 300.0;  // [s]
const SteadyStateOptions kShortRun{.observed_windows = 3, .series_samples = 10, .integration = {}};

// Two windows agree at once; all times are multiples of one interval, and none of the last window is left
// out.
TEST(RunToSteadyState, KeepsToOneInterval) {
  EvenMotion motion;
  motion.share = 0.8;
  const SteadyStateResult run = run_to_steady_state(motion, {kCageSpeed, 1.0}, kShortRun);
  EXPECT_TRUE(run.completed && run.steady) << run.message;
  EXPECT_EQ(run.windows.size(), 2u);
  EXPECT_EQ(run.report.steps, 7);
  // Every fifth of ten samples where only the steady state, or means of states, are requested.
  const std::vector<int> shown{5, 10, 15, 20, 25, 30, 35, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50};
  ASSERT_EQ(motion.times.size(), shown.size());
  const double interval = sample_interval({kCageSpeed, 1.0}, kShortRun);
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_DOUBLE_EQ(motion.times[i], shown[i] * interval);
  EXPECT_DOUBLE_EQ(run.duration, 5.0 * kRevolution);
  EXPECT_NEAR(run.orbit_slip(), 0.2, 1e-12);
}

// Loads of both bearings as passages of one; the series is that of the last window of the first.
TEST(RunToSteadyState, PoolsBearingsAndKeepsASeriesOfTheFirst) {
  EvenMotion motion;
  const SteadyStateResult run = run_to_steady_state(motion, {kCageSpeed, 1.0}, kShortRun);
  ASSERT_EQ(run.bearings.size(), 2u);
  const double one = std::sqrt(14.0 / 3.0);
  EXPECT_NEAR(run.bearings[0].inner.load_rms, one, 1e-12);
  EXPECT_NEAR(run.bearings[1].inner.load_rms, 2.0 * one, 1e-12);
  EXPECT_NEAR(run.statistics.inner.load_rms, std::sqrt(2.5) * one, 1e-12);
  ASSERT_EQ(run.series.time.size(), 10);
  EXPECT_EQ(run.series.time[0], motion.times[8]);
  EXPECT_EQ(run.series.time[9], motion.times[17]);
  EXPECT_EQ(run.series.inner_load(2, 9), 3.0);
}

// All bearings give a state at the look, whatever number of samples a window has.
TEST(RunToSteadyState, EndsAtALookWithStatesOfAllBearings) {
  for (const long samples : {3L, 7L, 500L}) {
    SteadyStateOptions options = kShortRun;
    options.series_samples = samples;
    options.look = {1, [] { return false; }};
    EvenMotion motion;
    motion.share = 0.8;
    const SteadyStateResult run = run_to_steady_state(motion, {kCageSpeed, 1.0}, options);
    ASSERT_TRUE(run.completed) << run.message;
    EXPECT_NEAR(run.duration, 3.0 * kRevolution, 1e-9 * kRevolution);
    for (const WindowStatistics& bearing : run.bearings) {
      EXPECT_NEAR(bearing.duration, kRevolution, 1e-9 * kRevolution) << samples;
      EXPECT_NEAR(bearing.orbit_speed, 0.8 * kCageSpeed, 1e-9 * std::abs(kCageSpeed)) << samples;
    }
  }
}

// One of several bearings at a time gives a state; over a run each of them does, in equal shares, and none
// always at the same position in a window.
TEST(RunToSteadyState, StatesComeFromAllBearingsInNoFixedPosition) {
  class Watched : public EvenMotion {
   public:
    mutable std::vector<std::pair<int, double>> seen;  // bearing, time [s]
    void take_snapshot(int b, bearing::motion::Snapshot& into) const override {
      EvenMotion::take_snapshot(b, into);
      seen.emplace_back(b, now());
    }
  };
  SteadyStateOptions options = kShortRun;
  options.observed_windows = 8;
  options.series_samples = 500;
  Watched motion;
  run_to_steady_state(motion, {kCageSpeed, 1.0}, options);
  int count[2] = {0, 0};
  std::set<long> phases[2];
  const double interval = kRevolution / 500.0;
  for (const auto& [b, time] : motion.seen) {
    const long sample = std::lround(time / interval);
    if (sample <= 1000 || sample > 4500 || sample % 500 == 0) continue;  // ends of windows, the series
    ++count[b];
    phases[b].insert(sample % 500);
  }
  EXPECT_NEAR(count[0], count[1], 0.1 * (count[0] + count[1]));
  for (const std::set<long>& of : phases) EXPECT_GT(of.size(), 60u);  // of 100
}

// A cage that lags makes the windows after the first longer, but not without bound.
TEST(RunToSteadyState, WindowsFollowTheCageWhereTheyMay) {
  for (const auto& [share, length] : {std::pair{0.8, 1.25}, std::pair{0.01, 4.0}}) {
    EvenMotion motion;
    motion.share = share;
    motion.one_interval = false;
    run_to_steady_state(motion, {kCageSpeed, 1.0}, kShortRun);
    ASSERT_EQ(motion.begins.size(), 4u);  // what is observed in two parts
    EXPECT_NEAR(motion.begins[1], kRevolution, 1e-9 * kRevolution);
    EXPECT_NEAR(motion.begins[2], (1.0 + length) * kRevolution, 1e-9 * kRevolution);
  }
}

TEST(RunToSteadyState, SaysWhyItEnded) {
  EvenMotion motion;
  motion.fails_at = 1.5 * kRevolution;
  const SteadyStateResult run = run_to_steady_state(motion, {kCageSpeed, 1.0}, kShortRun);
  EXPECT_FALSE(run.completed);
  EXPECT_EQ(run.message, "it failed");
  EXPECT_EQ(run.windows.size(), 1u);
  EXPECT_THROW(run_to_steady_state(motion, {0.0, 1.0}, kShortRun), std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::system::steady_state_test
