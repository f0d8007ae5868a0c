// Power that rollers lose as they tilt, in motion with steps that are long against the time of a tilt.
#include <gtest/gtest.h>

#include <vector>

#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/steady_state.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::system::tilt_loss_test {
namespace {

bearing::Bearing cut_bearing() {
  bearing::Bearing bearing = test::reducer_bearing();
  bearing.rollers().laminae = 12;
  return bearing;
}

bearing::OperatingPoint tilted_point(double sun_rpm) {
  bearing::OperatingPoint point = test::reducer_point(sun_rpm);
  point.bore_load *= sun_rpm / 6000.0;  // at constant torque
  point.bore_tilt = {3e-4, 0.0};
  return point;
}

TEST(TiltLoss, IsThatOfTheRatesWhereTheyAreKnown) {
  const bearing::Bearing bearing = cut_bearing();
  const auto parameters = test::reducer_parameters();
  const auto model = bearing_model(bearing, tilted_point(6000.0), parameters);
  const Eigen::VectorXd x = initial_state(bearing, model, parameters, 0.0).x;
  const auto loss = [&](double rate) {
    const std::vector<double> rates(static_cast<std::size_t>(model.layout.rollers), rate);
    bearing::motion::Snapshot snapshot;
    take_snapshot(model, x, snapshot, 0.0, rates.data());
    return snapshot.loss.race_damping;
  };
  constexpr double rate = 1e-3;  // [m/s]
  const double expected = model.layout.rollers * model.laminae->resistance() * rate * rate;
  EXPECT_NEAR((loss(rate) - loss(0.0)) / expected, 1.0, 1e-9);
  EXPECT_NEAR((loss(-rate) - loss(0.0)) / expected, 1.0, 1e-9);
}

TEST(TiltLoss, RatesAreChangesOverAStep) {
  const bearing::Bearing bearing = cut_bearing();
  const auto parameters = test::reducer_parameters();
  const bearing::vectorised::VectorBearing tilting(bearing_model(bearing, tilted_point(6000.0), parameters)),
      upright(bearing_model(bearing, test::reducer_point(6000.0), parameters));
  const auto& layout = tilting.layout();
  Eigen::VectorXd before = initial_state(bearing, tilting.model(), parameters, 0.0).x, now = before;
  const Eigen::Index first = 5 * layout.rollers;  // five numbers of each roller stand before
  for (Eigen::Index j = 0; j < layout.rollers; ++j) now[first + j] += 1e-9 * static_cast<double>(1 + j);
  const std::vector<double> rates =
      tilt_rates(layout, tilting.padded(before).data(), tilting.padded(now).data(), 1e-4);
  ASSERT_EQ(rates.size(), static_cast<std::size_t>(layout.rollers));
  for (std::size_t j = 0; j < rates.size(); ++j)
    EXPECT_NEAR(rates[j] / (1e-5 * static_cast<double>(1 + j)), 1.0, 1e-6);
  EXPECT_TRUE(tilt_rates(upright.layout(), nullptr, nullptr, 1e-4).empty());
}

// By the excess that steps leave it is ten times as large with the coarser ones.
TEST(TiltLoss, OfSlowMotionHoldsWithSmallerSteps) {
  const auto loss = [](double length_error) {
    SteadyStateOptions options;
    options.integration.method = integration::Method::linearly_implicit;
    options.allowed_length_error = length_error;
    options.observed_windows = 1;
    options.most_windows = 2;
    const SteadyStateResult run =
        run_to_steady_state(cut_bearing(), tilted_point(200.0), test::reducer_parameters(), options);
    EXPECT_TRUE(run.completed) << run.message;
    return run.statistics.loss.race_damping;
  };
  const double coarse = loss(2e-9), fine = loss(5e-11);
  EXPECT_NEAR(coarse / fine, 1.0, 0.5);
}

}  // namespace
}  // namespace orbearing::system::tilt_loss_test
