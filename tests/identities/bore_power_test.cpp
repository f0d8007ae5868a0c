// Friction moment times speed and the power of vibration are the loss: what a reader multiplies, he finds.
#include <gtest/gtest.h>

#include "coupling/system/monolithic.hpp"
#include "coupling/system/steady_state.hpp"
#include "tests/unit/cosim/coupled_reducer.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::system::bore_power_test {
namespace {

using bearing::motion::WindowStatistics;

// [-]  of the loss: losses are those of some hundred states of a window, and what is stored changes over it.
constexpr double kSampled = 0.02;

double taken_from_bore(const WindowStatistics& means, double speed) {
  return -means.bore_friction_moment * speed + means.vibration_power;
}

SteadyStateOptions short_run() {
  SteadyStateOptions options;
  options.observed_windows = 2;
  return options;
}

// A bore that a force of the meshes shakes: damping and the support of its pin lose what shakes it.
TEST(BorePower, OfAShakenBearing) {
  const bearing::Bearing bearing = test::reducer_bearing();
  bearing::motion::DynamicsParameters parameters = test::reducer_parameters();
  const bearing::OperatingPoint point = test::reducer_point(3000.0);
  const SteadyStateResult even = run_to_steady_state(bearing, point, parameters, short_run());
  parameters.excitation = {2.0 * M_PI * 7000.0, {{1, {400.0, 0.0}, {0.0, 400.0}}}};
  const SteadyStateResult shaken = run_to_steady_state(bearing, point, parameters, short_run());
  for (const SteadyStateResult* run : {&even, &shaken}) {
    ASSERT_TRUE(run->completed) << run->message;
    const double loss = run->statistics.loss.total();
    EXPECT_NEAR(taken_from_bore(run->statistics, point.outer_speed), loss, kSampled * loss);
  }
  EXPECT_LT(std::abs(even.statistics.vibration_power), kSampled * even.statistics.loss.total());
  EXPECT_GT(shaken.statistics.vibration_power, 3.0 * kSampled * shaken.statistics.loss.total());
}

// The same of gears and bearings as one system.
TEST(BorePower, OfBearingsAmongTheirGears) {
  const CoupledSetup setup = test::coupled_reducer();
  const double speed = coupled_model(setup).gears.operation.speeds.planet_relative;
  const bearing::BearingGeometry geometry = coupled_model(setup).bearing.geometry;
  const RollingSpeeds rolling{bearing::kinematic_cage_speed(geometry, 0.0, speed),
                              bearing::kinematic_roller_spin(geometry, 0.0, speed)};
  SteadyStateOptions options = short_run();
  options.most_windows = 2;
  Monolithic together(setup);
  together.initialize(0.0);
  const SteadyStateResult run = run_to_steady_state(together, rolling, options);
  ASSERT_TRUE(run.completed) << run.message;
  const double loss = run.statistics.loss.total();
  EXPECT_NEAR(taken_from_bore(run.statistics, speed), loss, kSampled * loss);
}

}  // namespace
}  // namespace orbearing::system::bore_power_test
