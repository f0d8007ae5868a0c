// The motion of bearings drawn at random, RANDOM_MOTIONS of them from number RANDOM_MOTIONS_FROM on, a tenth
// of that by explicit steps: each run ends with sound numbers or a reason. RANDOM_MOTIONS_TABLE: a
// file for one line about each.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/steady_state.hpp"
#include "mechanics/constants.hpp"
#include "tests/random_motions.hpp"

namespace orbearing::bearing::dynamics_random_test {
namespace {

using integration::Method;

constexpr int kRevolutions = 2;  // of the cage: one to settle, one that is observed
// A run that is not done by then ends with that reason: three in four are. RANDOM_MOTIONS_STEPS: another.
constexpr int kStepBudget = 60'000;

int number(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

system::SteadyStateOptions short_run(Method method, double first_roller) {
  system::SteadyStateOptions options;
  options.first_roller = first_roller;
  options.integration.method = method;
  options.least_windows = 1;
  options.most_windows = 1;
  options.observed_windows = 1;
  options.samples_per_window = 200;
  options.series_samples = 50;
  options.integration.most_steps = number("RANDOM_MOTIONS_STEPS", kStepBudget);
  return options;
}

bool sound(const motion::WindowStatistics& means) {
  return std::isfinite(means.inner.load_rms) && std::isfinite(means.outer.load_max) &&
         std::isfinite(means.inner.least_film) && std::isfinite(means.orbit_speed) &&
         std::isfinite(means.mean_spin) && std::isfinite(means.loss.total());
}

// Without the numbers.
std::string reason(const system::SteadyStateResult& run) {
  return run.completed ? "completed"
                       : run.message.substr(0, std::min(run.message.find(" at t ="), run.message.find(':')));
}

// Steps of the longest length allowed over the cage revolutions of the run.
double steps_of_longest_length(const MotionDraw& draw, const system::SteadyStateResult& run) {
  const auto model = motion::bearing_model(draw.bearing, draw.point, draw.parameters);
  return kRevolutions * constants::two_pi / std::abs(run.rolling.cage) / system::longest_step(model);
}

constexpr const char* kHead =
    "number,rollers,roller_diameter_m,clearance_m,pitch_speed_m_per_s,load_per_area_Pa,film,limiting_shear,"
    "mixed,guided,inner_guided,waves,unequal,viscosity_Pa_s,roughness_m,excitation,carrier_rad_per_s,"
    "longest_steps,steps,rejected,smallest_step_s,wall_s,cage_slip,ending";

void write_line(std::ostream& out, int n, const MotionDraw& draw, const system::SteadyStateResult& run) {
  const auto& race = draw.parameters.race;
  const double area =
      draw.bearing.rollers().diameter * draw.bearing.rollers().length * draw.bearing.rollers().count;
  out << n << ',' << draw.bearing.rollers().count << ',' << draw.bearing.rollers().diameter << ','
      << draw.bearing.radial_clearance << ',' << draw.pitch_speed << ',' << draw.point.bore_load.norm() / area
      << ',' << race.film_in_approach << ',' << (race.traction == TractionLaw::limiting_shear) << ','
      << (race.lubrication == motion::Lubrication::mixed) << ','
      << (draw.parameters.cage.guide_diameter > 0.0) << ',' << (draw.bearing.cage.guidance == Race::inner)
      << ',' << draw.bearing.inner.form.size() + draw.bearing.outer.form.size() << ','
      << draw.bearing.rollers().diameter_deviation.size() << ',' << draw.parameters.lubricant.viscosity << ','
      << race.roughness << ',' << draw.parameters.excitation.harmonics.size() << ','
      << draw.point.carrier.speed << ',' << steps_of_longest_length(draw, run) << ',' << run.report.steps
      << ',' << run.report.rejected << ',' << run.report.smallest_step << ',' << run.report.wall_seconds
      << ',' << run.orbit_slip() << ',' << reason(run) << std::endl;
}

class RandomDynamics : public testing::TestWithParam<Method> {};

TEST_P(RandomDynamics, EndsWithSoundNumbersOrAReason) {
  const bool readable = GetParam() == Method::dopri5;  // it takes ten times as long
  const int wanted = number("RANDOM_MOTIONS", 10), first = number("RANDOM_MOTIONS_FROM", 0);
  ASSERT_GT(wanted, 0) << "RANDOM_MOTIONS must be a positive number";
  const int draws = readable ? std::max(2, wanted / 10) : wanted;
  const char* table = std::getenv("RANDOM_MOTIONS_TABLE");
  std::ofstream lines(table == nullptr ? "" : table);
  lines << kHead << std::endl;
  std::map<std::string, int> endings;
  for (int n = first; n < first + draws; ++n) {
    const MotionDraw draw = RandomMotion(static_cast<unsigned>(n)).draw();
    SCOPED_TRACE("draw " + std::to_string(n) + " of seed " + std::to_string(kSeed));
    const system::SteadyStateResult run = system::run_to_steady_state(
        draw.bearing, draw.point, draw.parameters, short_run(GetParam(), draw.first_roller));
    ++endings[reason(run)];
    if (lines.is_open()) write_line(lines, n, draw, run);
    if (run.completed) {
      EXPECT_TRUE(sound(run.statistics)) << draw;
      const auto model = motion::bearing_model(draw.bearing, draw.point, draw.parameters);
      EXPECT_EQ(system::out_of_place(model, run.final_state), "") << draw;
    }
    EXPECT_TRUE(run.completed || !run.message.empty()) << draw;
    EXPECT_TRUE(run.final_state.allFinite()) << draw;
    // A run that hangs rejects steps without end; a sound one repeats fewer than it accepts.
    EXPECT_LE(run.report.steps + run.report.rejected, 2L * short_run(GetParam(), 0.0).integration.most_steps)
        << draw;
  }
  for (const auto& [ending, count] : endings) RecordProperty(ending, count);
  for (const auto& [ending, count] : endings) std::printf("%6d  %s\n", count, ending.c_str());
}

// In this one the carrier throws a cage that no land guides out of its pockets.
TEST(CageWithoutALand, EndsWithItsReasonWhereItIsThrownOut) {
  const MotionDraw draw = RandomMotion(5627).draw();
  ASSERT_EQ(draw.parameters.cage.guide_diameter, 0.0);
  const system::SteadyStateResult run = system::run_to_steady_state(
      draw.bearing, draw.point, draw.parameters, short_run(Method::linearly_implicit, draw.first_roller));
  EXPECT_FALSE(run.completed);
  EXPECT_EQ(run.message.rfind("the cage left the bearing", 0), 0u) << run.message;
  EXPECT_TRUE(run.final_state.allFinite());
}

INSTANTIATE_TEST_SUITE_P(Integrators, RandomDynamics,
                         testing::Values(Method::dopri5, Method::linearly_implicit),
                         [](const testing::TestParamInfo<Method>& method) {
                           return method.param == Method::dopri5 ? "readable" : "vectorised";
                         });

}  // namespace
}  // namespace orbearing::bearing::dynamics_random_test
