// Results of [Chen2026] for a motor's bearing under four conditions, and the heat of NASA's 35 mm bearing,
// compared with the runs of the shipped cases. docs/deep_groove.md lists what is reproduced and what is
// missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/case/static_case.hpp"

namespace orbearing::app::app_ball_runs_test {
namespace {

analysis::BallRun study_of(const std::string& name, const std::vector<std::string>& settings) {
  return ball_run(read_case(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings));
}

// From rest: a fifth of a second holds a turn of the cage at the lowest speed.
std::vector<analysis::BallRun> conditions() {
  std::vector<analysis::BallRun> all;
  for (const auto& [speed, load] :
       {std::pair{"1730 rpm", "938 N"}, {"3703 rpm", "903 N"}, {"1785 rpm", "266 N"}, {"3998 rpm", "206 N"}})
    all.push_back(study_of("deep_groove_motor",
                           {std::string("operation.shaft_speed=") + speed, std::string("load.radial=") + load,
                            "simulation.duration=0.2 s", "simulation.observed_share=0.7"}));
  return all;
}

// Figs. 7 and 8: heavy loads and high speeds give short lives, with the balls' own failure (Eq. (35)) and
// without; slip falls from all of it; the cage is struck at the start and hardly after.
TEST(ChenMotor, LivesSlipAndImpactsGoAsTheSourceHasThem) {
  const std::vector<analysis::BallRun> all = conditions();
  for (const auto life : {&analysis::BallRun::life_hours, &analysis::BallRun::life_with_balls_hours}) {
    EXPECT_LT(all[1].*life, all[0].*life);
    EXPECT_LT(all[0].*life, all[3].*life);
    EXPECT_LT(all[3].*life, all[2].*life);
  }
  for (const analysis::BallRun& study : all) {
    EXPECT_LT(study.life_with_balls_hours, study.life_hours);
    const system::BallSeries& series = study.run.series;
    EXPECT_EQ(series.cage_slip.front(), 1.0);
    EXPECT_LT(std::abs(study.run.means.cage_slip), 0.05);
    const auto late = series.pocket_load.begin() + static_cast<std::ptrdiff_t>(series.pocket_load.size() / 2);
    EXPECT_LT(*std::max_element(late, series.pocket_load.end()), 0.1 * study.run.pocket_load_max);
  }
  // Not reproduced: impacts that grow with the load. Here they grow with the speed that is to be caught up
  // with.
  EXPECT_GT(all[1].run.pocket_load_max, 1.5 * all[0].run.pocket_load_max);
  EXPECT_NEAR(all[0].run.pocket_load_max / all[2].run.pocket_load_max, 1.0, 0.1);
}

// Untuned: within 16 % of the measurement at all speeds. Oil that rotates takes less than stationary oil, and
// its heat does not grow the fastest.
TEST(Nasa35mm, HeatIsWithinSixteenPercent) {
  const std::pair<const char*, double> measured[] = {
      {"28000 rpm", 350.0}, {"48000 rpm", 700.0}, {"64000 rpm", 1100.0}, {"72000 rpm", 1400.0}};
  for (const auto& [speed, heat] : measured) {
    const analysis::BallRun study = study_of("nasa_35mm", {std::string("operation.shaft_speed=") + speed});
    const bearing::balls::BallPowerLoss& loss = study.run.means.loss;
    EXPECT_NEAR(loss.total(), heat, 0.16 * heat) << speed;
    EXPECT_LT(loss.churning, 0.35 * loss.total()) << speed;
  }
}

// The whirl of the cage begins by itself in a bearing whose load has no direction. A start that differs by
// round-off, other samples and a longer run give the same heat within the error that is printed.
TEST(Nasa35mm, HeatIsKnownToItsError) {
  const auto heat_of = [](const std::vector<std::string>& settings) {
    std::vector<std::string> all{"operation.shaft_speed=28000 rpm"};
    all.insert(all.end(), settings.begin(), settings.end());
    return study_of("nasa_35mm", all).run.means;
  };
  const system::BallMeans means = heat_of({});
  EXPECT_GT(means.heat_error, 1e-4 * means.loss.total());
  EXPECT_LT(means.heat_error, 0.02 * means.loss.total());
  for (const char* setting :
       {"bearing.radial_clearance=1e-11 m", "simulation.duration=0.8 s", "simulation.samples=1000"}) {
    const system::BallMeans other = heat_of({setting});
    // Twice: 95 % of such pairs are within the root of the sum of squares.
    EXPECT_NEAR(other.loss.total(), means.loss.total(), 2.0 * std::hypot(other.heat_error, means.heat_error))
        << setting;
  }
  // A run that ends while the whirl still grows says so by its error.
  EXPECT_GT(heat_of({"simulation.duration=0.03 s"}).heat_error, 3.0 * means.heat_error);
}

}  // namespace
}  // namespace orbearing::app::app_ball_runs_test
