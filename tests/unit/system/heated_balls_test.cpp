// A small thermal network that is integrated with averages.
#include "coupling/system/heated_balls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bearing/life/standard_life.hpp"
#include "tests/messages.hpp"
#include "tests/unit/system/small_ball_bearing.hpp"

namespace orbearing::system::heated_balls_test {
namespace {

Eigen::VectorXd of(std::initializer_list<double> values) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) v[i++] = value;
  return v;
}

ThermalNetwork two_bodies() {
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(2, 2);
  between(0, 1) = between(1, 0) = 4.0;
  return {of({50.0, 200.0}), between, of({0.0, 2.0}), of({20.0, 30.0})};
}

// Steps of `length` [s] as those of warm_to_steady(), `count` of them: where they end [degC].
Eigen::VectorXd warm_up(const ThermalNetwork& network, const HeatSource& source, Eigen::VectorXd temperature,
                        double length, int count) {
  for (int i = 0; i < count; ++i) {
    const Eigen::VectorXd heat = source(temperature);
    const Eigen::VectorXd mean = 0.5 * (heat + source(network.after(temperature, heat, length)));
    temperature = network.after(temperature, mean, length);
  }
  return temperature;
}

TEST(ThermalNetwork, SteadyTemperaturesAreThoseOfTheHandCalculation) {
  const Eigen::VectorXd steady = two_bodies().steady(of({12.0, 8.0}));
  EXPECT_NEAR(steady[1], 30.0 + 20.0 / 2.0, 1e-12);
  EXPECT_NEAR(steady[0], steady[1] + 12.0 / 4.0, 1e-12);
}

TEST(ThermalNetwork, GoesOnAsSmallStepsDo) {
  const ThermalNetwork network = two_bodies();
  Eigen::VectorXd at = of({20.0, 25.0});
  const Eigen::VectorXd heat = of({12.0, 8.0});
  const Eigen::VectorXd exact = network.after(at, heat, 60.0);
  constexpr int steps = 600000;
  for (int i = 0; i < steps; ++i) {
    const double h = 60.0 / steps, across = 4.0 * (at[0] - at[1]);
    at += h * of({(12.0 - across) / 50.0, (8.0 + across - 2.0 * (at[1] - 30.0)) / 200.0});
  }
  EXPECT_NEAR(at[0], exact[0], 1e-4);
  EXPECT_NEAR(at[1], exact[1], 1e-4);
  EXPECT_NEAR((network.after(network.after(of({20.0, 25.0}), heat, 20.0), heat, 40.0) - exact).norm(), 0.0, 1e-10);
}

TEST(ThermalNetwork, RefusesHeatWithoutAWayOut) {
  EXPECT_REFUSED(std::invalid_argument, "heated_balls 1",
                 ThermalNetwork(of({1.0, 1.0}), Eigen::MatrixXd::Zero(2, 2), of({1.0, 0.0}), of({20.0, 20.0})));
  EXPECT_REFUSED(std::invalid_argument, "heated_balls 2",
                 ThermalNetwork(of({0.0}), Eigen::MatrixXd::Zero(1, 1), of({1.0}), of({20.0})));
}

// Heat that falls as it gets warmer, as with oil: the steps are of second order.
TEST(WarmUp, StepsAreOfSecondOrder) {
  const ThermalNetwork network = two_bodies();
  const HeatSource source = [](const Eigen::VectorXd& t) { return of({30.0 * std::exp(-0.03 * (t[0] - 20.0)), 1.0}); };
  const auto after = [&](int steps) {
    return warm_up(network, source, of({20.0, 20.0}), 200.0 / steps, steps);
  };
  const Eigen::VectorXd exact = after(4096);
  const double coarse = (after(64) - exact).norm(), fine = (after(128) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2);
}

TEST(WarmUp, EndsWhereAsMuchLeavesAsArises) {
  const ThermalNetwork network = two_bodies();
  const HeatSource source = [](const Eigen::VectorXd& t) { return of({30.0 * std::exp(-0.03 * (t[0] - 20.0)), 1.0}); };
  const WarmState end = warm_to_steady(network, source, of({20.0, 20.0}), 0.5, 1e-9).back();
  EXPECT_NEAR(network.leaving(end.temperature), source(end.temperature).sum(), 1e-6 * end.heat.sum());
}

struct Small {
  bearing::Bearing bearing = small_ball_bearing(5e-6);
  bearing::balls::MotionParameters parameters = small_ball_motion();
  bearing::balls::BallDuty duty;
  bearing::rating::ContactCapacities capacities;
  BallRunOptions options;

  Small() {
    parameters.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
    duty.inner = bearing::balls::RingDrive::steady(400.0);
    duty.on_inner = {{500.0, 0.0, 800.0, 0.0, 0.0}};
    capacities = bearing::rating::ratings_of(bearing, {}).contacts;
    options.duration = 0.1;
    options.observed = 0.8;
    options.samples = 200;
  }
};

Eigen::VectorXd at(double of_balls, double inner, double outer) {
  return of({of_balls, inner, outer, 50.0, 30.0});
}

// At one temperature throughout, the bearing is a larger one of the same shape.
TEST(HeatedBalls, EvenHeatingScalesTheFreeBearing) {
  Small small;
  for (const double angle : {0.0, 0.4}) {
    small.bearing.elements = bearing::Balls{7, 9.52e-3, angle};
    const HeatParameters heat{.on = true, .expansion = 12e-6, .sizes_at = 20.0};
    const bearing::Bearing warm = warm_bearing(small.bearing, heat, at(70.0, 70.0, 70.0));
    const double scale = 1.0 + 12e-6 * 50.0;
    EXPECT_NEAR(warm.balls().diameter, scale * 9.52e-3, 1e-15);
    EXPECT_NEAR(warm.pitch_diameter, scale * 36e-3, 1e-14);
    EXPECT_NEAR(warm.radial_clearance, scale * 5e-6, 1e-14);
    EXPECT_NEAR(warm.inner.osculation, small.bearing.inner.osculation, 1e-14);
    EXPECT_NEAR(warm.outer.osculation, small.bearing.outer.osculation, 1e-14);
    EXPECT_EQ(warm.contact_angle(), angle);
  }
}

// Races of 36 - 9.52 - 0.0025 and 36 + 9.52 + 0.0025 mm, 11.5e-6 1/K.
TEST(HeatedBalls, ClearanceFollowsTheTemperaturesByHand) {
  const Small small;
  const HeatParameters heat{.on = true};
  const auto clearance = [&](double of_balls, double inner, double outer) {
    return warm_bearing(small.bearing, heat, at(of_balls, inner, outer)).radial_clearance;
  };
  EXPECT_NEAR(clearance(20.0, 20.0, 20.0), 5e-6, 1e-15);
  EXPECT_NEAR(clearance(20.0, 30.0, 20.0) - 5e-6, -11.5e-6 * 10.0 * 26.4775e-3, 1e-12);
  EXPECT_NEAR(clearance(20.0, 20.0, 30.0) - 5e-6, 11.5e-6 * 10.0 * 45.5225e-3, 1e-12);
  EXPECT_NEAR(clearance(30.0, 20.0, 20.0) - 5e-6, -11.5e-6 * 10.0 * 2.0 * 9.52e-3, 1e-12);
  // An inner ring 16.4 K warmer than the outer one closes it.
  EXPECT_NEAR(clearance(20.0, 20.0 + 5e-6 / (11.5e-6 * 26.4775e-3), 20.0), 0.0, 1e-12);
}

// The parts in motion have the clearance: grooves are apart by the distance that their own circles and radii
// leave.
TEST(HeatedBalls, GroovesGrowWithTheirOwnRings) {
  Small small;
  small.bearing.elements = bearing::Balls{7, 9.52e-3, 0.3};
  const HeatParameters heat{.on = true};
  const auto numbers = [&](const bearing::Bearing& b) { return ball_numbers(b, small.parameters); };
  const auto cold = numbers(small.bearing),
             warm = numbers(warm_bearing(small.bearing, heat, at(60.0, 80.0, 40.0)));
  const double by[] = {1.0 + 11.5e-6 * 40.0, 1.0 + 11.5e-6 * 60.0, 1.0 + 11.5e-6 * 20.0};
  EXPECT_NEAR(warm.radius, by[0] * cold.radius, 1e-15);
  EXPECT_NEAR(warm.inner.centre_radius, by[1] * cold.inner.centre_radius, 1e-14);
  EXPECT_NEAR(warm.outer.centre_radius, by[2] * cold.outer.centre_radius, 1e-14);
  EXPECT_NEAR(warm.inner.play + warm.radius, by[1] * (cold.inner.play + cold.radius), 1e-15);
  EXPECT_NEAR(warm.outer.play + warm.radius, by[2] * (cold.outer.play + cold.radius), 1e-15);
}

// Heat capacities made so small that the bearing is warm after a tenth of a second: integrated step by step,
// and by samples of a millisecond at every fifth.
TEST(HeatedBalls, AveragingIsTheDirectIntegration) {
  Small small;
  HeatParameters heat{.on = true};
  // Time constants of the real network over a factor of some thousands.
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(kWarmBodies, kWarmBodies);
  for (int i = 0; i < kWarmBodies; ++i)
    for (int k = 0; k < kWarmBodies; ++k)
      if (i != k) between(i, k) = 2.0;
  const ThermalNetwork network(Eigen::VectorXd::Constant(kWarmBodies, 0.01), between,
                               Eigen::VectorXd::Constant(kWarmBodies, 0.05),
                               Eigen::VectorXd::Constant(kWarmBodies, 25.0));
  const auto temperatures = [&](double step, int count) {
    std::vector<double> state;
    const HeatSource source = [&](const Eigen::VectorXd& t) {
      bearing::balls::MotionParameters warm = small.parameters;
      warm.lubricant.viscosity = viscosity_at(0.05, 0.03, heat, t[3]);
      BallRunOptions look = small.options;
      look.duration = 1e-3;
      look.observed = 1.0;
      look.samples = 20;
      look.from = state;
      BallRunResult run = run_balls(small.bearing, warm, small.duty, small.capacities, look);
      EXPECT_TRUE(run.completed) << run.message;
      state = run.final_state;
      return heat_by_body(run.means.loss);
    };
    const Eigen::VectorXd cold = Eigen::VectorXd::Constant(kWarmBodies, 25.0);
    source(cold);  // balls find their way
    return warm_up(network, source, cold, step, count);
  };
  const Eigen::VectorXd direct = temperatures(1e-3, 100), averaged = temperatures(5e-3, 20);
  EXPECT_GT(direct[0], 28.0);
  EXPECT_LT((averaged - direct).cwiseAbs().maxCoeff(), 0.02 * (direct[0] - 25.0));
}

TEST(HeatedBalls, SteadyTemperaturesCloseTheBalanceOfHeat) {
  Small small;
  const HeatParameters heat{.on = true};
  std::vector<WarmState> warming;
  small.parameters.lubricant.viscosity = 0.05;
  const BallRunResult run =
      run_heated_balls(small.bearing, small.parameters, small.duty, small.capacities, small.options, heat, warming);
  ASSERT_TRUE(run.completed) << run.message;
  const ThermalNetwork network = thermal_network(ball_numbers(small.bearing, small.parameters), heat);
  const Eigen::VectorXd& end = warming.back().temperature;
  EXPECT_NEAR(network.leaving(end), run.means.loss.total(), 1e-6 * run.means.loss.total());
  EXPECT_GT(end[0], 26.0);
  EXPECT_GT(end[0], end[4]);
  // A cooler housing runs cooler.
  HeatParameters cooled = heat;
  cooled.housing = 30.0;
  std::vector<WarmState> cool;
  run_heated_balls(small.bearing, small.parameters, small.duty, small.capacities, small.options, cooled, cool);
  EXPECT_LT(cool.back().temperature[0], end[0]);
}

// All heat leaves with the oil: what the last run makes is what warms it, and more oil stays cooler.
TEST(HeatedBalls, OilAloneTakesAllHeatToItsOutlet) {
  Small small;
  const HeatParameters heat{.on = true, .model = HeatModel::oil, .inlet = 60.0, .stated_at = 60.0};
  small.parameters.lubricant.viscosity = 0.02;
  small.parameters.race.viscosity_slope = 0.03;
  const auto outlet = [&](double flow) {
    small.parameters.mixture.flow = flow;
    std::vector<WarmState> warming;
    const BallRunResult run = run_heated_balls(small.bearing, small.parameters, small.duty, small.capacities,
                                               small.options, heat, warming);
    EXPECT_TRUE(run.completed) << run.message;
    const double last = warming.back().temperature[3], used = warming[warming.size() - 2].temperature[3];
    EXPECT_NEAR(last, 60.0 + run.means.loss.total() / (1.7e6 * flow), 1e-9);
    EXPECT_NEAR(last, used, std::max(kOutletError, run.means.heat_error / (1.7e6 * flow)));
    EXPECT_LT(std::abs(last - used), 0.5);
    // The run has the viscosity of the temperature before: by that temperature alone.
    bearing::balls::MotionParameters same = small.parameters;
    same.lubricant.viscosity = 0.02 * std::exp(-0.03 * (used - 60.0));
    const BallRunResult again = run_balls(small.bearing, same, small.duty, small.capacities, small.options);
    EXPECT_DOUBLE_EQ(again.means.loss.total(), run.means.loss.total());
    return last;
  };
  small.parameters.mixture.flow = 0.0;
  std::vector<WarmState> none;
  EXPECT_REFUSED(std::invalid_argument, "heated_balls flow",
                 run_heated_balls(small.bearing, small.parameters, small.duty, small.capacities, small.options, heat, none));
  const double little = outlet(2e-8), more = outlet(2e-7);
  EXPECT_GT(little, more + 1.0);
  EXPECT_GT(more, 60.0);
}

}  // namespace
}  // namespace orbearing::system::heated_balls_test
