// The motion of bearings drawn at random, RANDOM_BEARINGS of them: each run ends with sound numbers or a
// reason.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

#include "coupling/integration/steady_state.hpp"
#include "tests/random_bearings.hpp"

namespace orbearing::bearing {
namespace {

// Loads in time are bounded by what the races stand: a pressure of some 4 GPa over the projected area of a
// roller.
constexpr double kLargestLoadPerArea = 2e8;  // [Pa]  of roller diameter times length
constexpr long kStepBudget = 60'000;         // a run that is not done by then ends with that reason

Draw sensible(Draw draw, double share) {
  const double area = draw.bearing.roller_diameter * draw.bearing.roller_length;
  const double largest = kLargestLoadPerArea * area * draw.bearing.rollers / 4.0;
  draw.point.bore_load *= share * largest / draw.point.bore_load.norm();
  draw.point.carrier.acceleration = 0.0;
  draw.bearing.radial_clearance = std::abs(draw.bearing.radial_clearance);
  return draw;
}

integration::SteadyStateOptions short_run(integration::Method method) {
  integration::SteadyStateOptions options;
  options.integration.method = method;
  options.least_windows = 1;
  options.most_windows = 1;
  options.observed_windows = 1;
  options.samples_per_window = 200;
  options.series_samples = 50;
  options.integration.most_steps = kStepBudget;
  return options;
}

bool sound(const dynamics::WindowStatistics& means) {
  return std::isfinite(means.inner.load_rms) && std::isfinite(means.outer.load_max) &&
         std::isfinite(means.cage_speed) && std::isfinite(means.loss.total());
}

class RandomDynamics : public testing::TestWithParam<integration::Method> {};

TEST_P(RandomDynamics, EndsWithSoundNumbersOrAReason) {
  const char* text = std::getenv("RANDOM_BEARINGS");
  const int draws = text == nullptr ? 10 : std::atoi(text);
  ASSERT_GT(draws, 0) << "RANDOM_BEARINGS must be a positive number";
  RandomBearings bearings;
  std::mt19937_64 engine(kSeed);
  std::uniform_real_distribution<double> exponent(-3.0, 0.0);
  std::map<std::string, int> endings;
  for (int i = 0; i < draws; ++i) {
    const Draw draw = sensible(bearings.next(), std::pow(10.0, exponent(engine)));
    dynamics::DynamicsParameters parameters;
    parameters.race.film_in_approach = draw.options.film.has_value();
    const integration::SteadyStateResult run =
        integration::run_to_steady_state(draw.bearing, draw.point, parameters, short_run(GetParam()));
    ++endings[run.completed ? "completed" : run.message.substr(0, 40)];
    if (run.completed) {
      EXPECT_TRUE(sound(run.statistics)) << draw;
    }
    EXPECT_TRUE(run.completed || !run.message.empty()) << draw;
    EXPECT_TRUE(run.final_state.allFinite()) << draw;
  }
  for (const auto& [ending, count] : endings) RecordProperty(ending, count);
  for (const auto& [ending, count] : endings) std::printf("%6d  %s\n", count, ending.c_str());
}

INSTANTIATE_TEST_SUITE_P(Integrators, RandomDynamics,
                         testing::Values(integration::Method::dopri5, integration::Method::linearly_implicit),
                         [](const testing::TestParamInfo<integration::Method>& method) {
                           return method.param == integration::Method::dopri5 ? "readable" : "vectorised";
                         });

}  // namespace
}  // namespace orbearing::bearing
