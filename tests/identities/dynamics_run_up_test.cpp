// Speeds that change in time: loads, angles and the motion that follows.
#include <gtest/gtest.h>

#include "bearing/motion/model.hpp"
#include "bearing/motion/model_constants.hpp"
#include "coupling/system/steady_state.hpp"
#include "tests/messages.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::dynamics_run_up_test {
namespace {

constexpr double kRoundOff = 1e-12;

BearingModel ramping_model(double ramp) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.driving.ramp = ramp;
  return bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters);
}

// When the speed has doubled, the load is that of the doubled speed at the same power, and Euler's load.
TEST(RunUp, LoadsAreThoseOfTheSpeedThatIsReached) {
  const double ramp = 20.0;
  const BearingModel model = ramping_model(ramp);
  for (double ratio : {0.5, 1.0, 1.7, 2.0}) {
    const double time = (ratio - 1.0) / ramp;
    const OperatingPoint reached = test::reducer_point(6000.0 * ratio);
    const double euler = -0.186 * ramp * model.point.carrier.speed * model.frame.orbit_radius;
    const Vector2 expected = reached.bore_load + Vector2(0.0, euler);
    EXPECT_LT((bore_load(model, time) - expected).norm(), kRoundOff * expected.norm());
    const CarrierFrame frame = frame_at(model, time);
    EXPECT_NEAR(frame.coriolis_speed, reached.carrier.speed, kRoundOff * reached.carrier.speed);
    EXPECT_NEAR(frame.centrifugal, std::pow(reached.carrier.speed, 2), kRoundOff * frame.centrifugal);
    EXPECT_NEAR(frame.euler, ramp * model.point.carrier.speed, kRoundOff * frame.euler);
  }
}

TEST(RunUp, AnglesAreTheIntegralsOfTheSpeeds) {
  const BearingModel model = ramping_model(-40.0);
  const auto bore = [&](double time) { return vectorised::surroundings_at(model, time).bore; };
  const double time = 0.01, step = 1e-5;
  const double slope = (bore(time + step).turned - bore(time - step).turned) / (2.0 * step);
  const double speed = bore(time).speed;
  EXPECT_NEAR(slope, speed, 1e-10 * std::abs(speed)) << "a parabola's central difference is exact";
  EXPECT_NEAR(speed, 0.6 * model.point.outer_speed, kRoundOff * std::abs(speed));
  EXPECT_EQ(bore(0.0).turned, 0.0);
}

TEST(RunUp, RefusesAnAccelerationBesidesItsOwn) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.driving.ramp = 1.0;
  OperatingPoint point = test::reducer_point(6000.0);
  point.carrier.acceleration = 10.0;
  EXPECT_THROW(bearing_model(test::reducer_bearing(), point, parameters), std::invalid_argument);
}

system::SteadyStateOptions short_options() {
  system::SteadyStateOptions options;
  options.least_windows = options.most_windows = 1;
  options.samples_per_window = 400;
  options.series_samples = 100;
  options.integration = {};
  return options;
}

// From 6000 to 7200 rpm in 10 ms: the cage follows the bore, and the carrier's acceleration presses the
// bearing against the turn of the carrier by the planet's Euler load, a hundredth of the mesh load here.
TEST(RunUp, CageFollowsTheSpeed) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.driving.ramp = 20.0;
  const auto run =
      system::run_up(test::reducer_bearing(), test::reducer_point(6000.0), parameters, short_options(), 0.01);
  ASSERT_TRUE(run.completed) << run.message;
  EXPECT_NEAR(run.orbit_slip(), 0.0, 0.02);
  const double kinematic = run.rolling.cage / 1.1;
  const Eigen::Index n = run.series.orbit_speed.size();
  EXPECT_NEAR(run.series.orbit_speed.head(n / 10).mean() / kinematic, 1.01, 0.02);
  EXPECT_NEAR(run.series.orbit_speed.tail(n / 10).mean() / kinematic, 1.19, 0.02);
  EXPECT_NEAR(run.series.time[n - 1], 0.01, 2e-4);
}

TEST(RunUp, RefusesToComeToRest) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.driving.ramp = -20.0;
  const Bearing bearing = test::reducer_bearing();
  const OperatingPoint point = test::reducer_point(6000.0);
  system::SteadyStateOptions looking = short_options();
  looking.look.windows = 1;
  EXPECT_REFUSED(std::invalid_argument, "run-up to rest",
                 (void)system::run_up(bearing, point, parameters, short_options(), 0.05));
  EXPECT_REFUSED(std::invalid_argument, "run-up to settle",
                 (void)system::run_to_steady_state(bearing, point, parameters, short_options()));
  EXPECT_REFUSED(std::invalid_argument, "run-up among windows",
                 (void)system::run_up(bearing, point, parameters, looking, 0.01));
}

}  // namespace
}  // namespace orbearing::bearing::motion::dynamics_run_up_test
