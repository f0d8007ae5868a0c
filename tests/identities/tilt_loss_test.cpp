// Power that rollers lose as they tilt, in motion with steps that are long against the time of a tilt.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/free_bearing.hpp"
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
  const double expected =
      static_cast<double>(model.layout.rollers) * model.laminae->resistance() * rate * rate;
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

// Mean power of tilting [W] while a roller passes, by rates and by the excess.
struct Losses {
  double by_rates = 0.0, by_excess = 0.0;
};
Losses losses(double length_error) {
  const bearing::Bearing bearing = cut_bearing();
  auto parameters = test::reducer_parameters();
  parameters.lubricant = {.viscosity = 0.01, .pressure_viscosity = 1.5e-8};
  parameters.race.film_in_approach = parameters.race.squeeze = true;
  const auto model = bearing_model(bearing, tilted_point(100.0), parameters);
  bearing::vectorised::VectorBearing moving(model);
  Eigen::VectorXd x = initial_state(bearing, model, parameters, 0.0).x;
  integration::IntegrationOptions options;
  options.allowed_error = allowed_errors(model, length_error);
  constexpr long kSamples = 400;
  const double passage =
      2.0 * M_PI / (static_cast<double>(model.layout.rollers) * std::abs(model.kinematic_cage_speed));
  std::vector<double> rates;
  const std::vector<double> none(static_cast<std::size_t>(model.layout.rollers), 0.0);
  Losses mean;
  const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& now) {
    const auto damping = [&](const double* tilt_rate) {
      bearing::motion::Snapshot snapshot;
      take_snapshot(model, now, snapshot, time, tilt_rate);
      return snapshot.loss.race_damping;
    };
    const double rest = damping(none.data());
    mean.by_rates += (damping(rates.data()) - rest) / kSamples;
    mean.by_excess += (damping(nullptr) - rest) / kSamples;
  };
  const auto report = integrate_bearing(moving, x, {0.0, passage / kSamples, kSamples}, options, observe,
                                        nullptr, nullptr, &rates);
  EXPECT_TRUE(report.completed) << report.message;
  return mean;
}

TEST(TiltLoss, OfSlowMotionIsLessOfAnErrorOfTheStepsByRates) {
  constexpr double kShare = 0.25;  // of the error by the excess; a fifth was found
  const Losses coarse = losses(2e-10), fine = losses(1e-11);
  EXPECT_GT(coarse.by_excess, 5.0 * fine.by_excess);  // an error
  EXPECT_LT(std::abs(coarse.by_rates - fine.by_rates), kShare * std::abs(coarse.by_excess - fine.by_excess));
}

}  // namespace
}  // namespace orbearing::system::tilt_loss_test
