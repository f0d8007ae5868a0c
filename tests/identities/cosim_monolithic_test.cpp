// Gears and bearings as one system: its state, its samples, what it refuses.
#include <gtest/gtest.h>

#include <stdexcept>

#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/monolithic.hpp"
#include "tests/messages.hpp"
#include "tests/unit/cosim/coupled_reducer.hpp"

namespace orbearing::system::cosim_monolithic_test {
namespace {

// Without impacts, gears and bearings take steps of order 4, longer than the longest of order 2, few are
// rejected, and no bearing is substepped.
TEST(Monolithic, TakesLongStepsWithOil) {
  constexpr double kSeconds = 10e-3;
  Monolithic system(test::oiled_reducer());
  system.initialize(0.0);
  system.advance({0.0, kSeconds});
  const integration::IntegrationReport report = system.report();
  const auto steps = static_cast<double>(report.steps);
  EXPECT_EQ(system.substepped(), 0);
  EXPECT_LT(static_cast<double>(report.rejected), 0.1 * (steps + static_cast<double>(report.rejected)));
  const CoupledModel model = coupled_model(test::oiled_reducer());
  EXPECT_GT(kSeconds / steps, longest_step(model.bearing));
}

// A ring as light as this swings so fast on its rollers that its time bounds the steps, and no error does;
// yet the rollers do not pass so slowly that steps follow them.
TEST(Monolithic, NoStepWithOilIsLongerThanTheRingAllows) {
  constexpr double kSeconds = 0.1e-3;
  CoupledSetup setup = test::oiled_reducer();
  setup.bearing.dynamics.bore_mass *= 4e-3;
  const CoupledModel model = coupled_model(setup);
  const bearing::motion::BearingModel& one = model.bearing_of(0);
  const double longest =
      fourth_order_steps(bearing::vectorised::VectorBearing(one), allowed_errors(one, 1e-10)).longest;
  Monolithic system(setup);
  system.initialize(0.0);
  system.advance({0.0, kSeconds});
  // The last one is stretched over what is left of the window.
  EXPECT_GT(static_cast<double>(system.report().steps) + 1.0, kSeconds / longest);
}

// Steps that pass the requested times, and states between them, against windows that end there.
TEST(Monolithic, FollowedIsAsInWindows) {
  CoupledSetup setup = test::coupled_reducer();
  setup.bearing.allowed_length_error = 1e-14;
  setup.gears.allowed_share = 1e-8;
  Monolithic windows(setup), followed(setup);
  windows.initialize(0.0);
  followed.initialize(0.0);
  for (int k = 1; k <= 40; ++k) {
    const double time = 2.53e-6 * k;
    windows.advance({2.53e-6 * (k - 1), time});
    followed.follow(time);
    EXPECT_EQ(followed.time(), time);
    for (int i = 0; i < 4; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const PlanetMotion one = windows.gears().planets[index], other = followed.gears().planets[index];
      EXPECT_LT((one.displacement - other.displacement).norm(), 1e-11);  // [m]
      EXPECT_LT((one.velocity - other.velocity).norm(), 1e-5);           // [m/s]
    }
    for (int b = 0; b < 8; ++b) {
      const Eigen::Vector2d force = windows.reaction(b).force;
      EXPECT_LT((followed.reaction(b).force - force).norm(), 1e-3 * force.norm());
    }
  }
  EXPECT_REFUSED(std::runtime_error, "followed window", followed.advance({1.0, 2.0}));
}

// Damage of each bearing from the start to `end` [s], mean over the bins of both races [N^4]: inverse of the
// life.
std::vector<double> damage_over(double end, Monolithic& system) {
  system.initialize(0.0);
  bearing::motion::Snapshot start;
  std::vector<bearing::motion::StatisticsCollector> collectors;
  for (int b = 0; b < system.bearings(); ++b) {
    system.take_snapshot(b, start);
    collectors.emplace_back(start.angle.size(), 72);
    collectors.back().begin(0.0, start);
  }
  StepObservers observers;
  for (bearing::motion::StatisticsCollector& one : collectors) observers.loads.push_back(&one);
  system.observe_steps(observers);
  system.advance({0.0, end});
  std::vector<double> damage;
  for (int b = 0; b < system.bearings(); ++b) {
    bearing::motion::StatisticsCollector& one = collectors[static_cast<std::size_t>(b)];
    system.take_snapshot(b, start);
    one.add_state(end, start);
    const bearing::motion::WindowStatistics means = one.means();
    damage.push_back(means.inner.damage.mean() + means.outer.damage.mean());
  }
  return damage;
}

TEST(Monolithic, SubstepsBearingsWithoutHarm) {
  CoupledSetup setup = test::coupled_reducer(), even = setup;
  even.most_substepped = 0;
  Monolithic substepped(setup), plain(even);
  const std::vector<double> of_substepped = damage_over(10e-3, substepped),
                            of_plain = damage_over(10e-3, plain);
  EXPECT_GT(substepped.substepped(), 100);
  EXPECT_EQ(plain.substepped(), 0);
  EXPECT_LT(substepped.report().steps, plain.report().steps);
  for (std::size_t b = 0; b < 8; ++b) EXPECT_NEAR(of_substepped[b], of_plain[b], 0.03 * of_plain[b]);
}

TEST(Monolithic, BearingsCarryWhatTheMeshesLeave) {
  const CoupledSetup setup = test::coupled_reducer();
  Monolithic system(setup);
  system.initialize(0.0);
  system.advance({0.0, 5e-3});
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  constexpr int kSamples = 400;
  for (int k = 0; k < kSamples; ++k) {
    system.advance({5e-3 + k * 20e-6, 5e-3 + (k + 1) * 20e-6});
    for (int b = 0; b < 8; ++b) mean += system.reaction(b).force / kSamples;
  }
  const double carrier_torque = -4.0 * setup.gears.set.carrier.radius * mean.y() / 4.0;
  EXPECT_NEAR(carrier_torque, std::abs(setup.gears.operation.torques.carrier),
              0.02 * std::abs(carrier_torque));
  bearing::motion::Snapshot first, second;
  system.take_snapshot(0, first);
  system.take_snapshot(1, second);
  EXPECT_FALSE((first.inner.load == second.inner.load).all()) << "no copies of each other";
}

TEST(Monolithic, RefusesWhatItDoesNotKnow) {
  CoupledSetup setup = test::coupled_reducer();
  setup.gears.set.planet.coupled_bearing = false;
  EXPECT_REFUSED(std::invalid_argument, "on springs", Monolithic{setup});
  setup = test::coupled_reducer();
  setup.bearings_per_planet = 0;
  EXPECT_REFUSED(std::invalid_argument, "no bearings", Monolithic{setup});
  setup = test::coupled_reducer();
  setup.scratched = {{.planet = 4}};
  EXPECT_REFUSED(std::invalid_argument, "scratched planet", Monolithic{setup});
  setup.scratched = {{.planet = 0, .bearing = 2}};
  EXPECT_REFUSED(std::invalid_argument, "scratched bearing", Monolithic{setup});
}

}  // namespace
}  // namespace orbearing::system::cosim_monolithic_test
