#include "app/study/sensitivity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::sensitivity_test {
namespace {

using testing::HasSubstr;

constexpr double kRevolutions = 30.0 / 3.14159265358979323846;  // rpm of 1 rad/s

// A substitute for the motion: life decreases from 2000 rpm, and grows with the pin's stiffness.
analysis::PointResult made_up(const std::vector<analysis::NamedSet>& sets, analysis::Fidelity fidelity) {
  EXPECT_EQ(fidelity, analysis::Fidelity::monolithic);
  const analysis::PlanetaryDrivetrain& drivetrain = sets.front().drivetrain;
  analysis::PointResult point;
  const double rpm = kRevolutions * drivetrain.drive.speed;
  point.life_hours = 1e-6 * drivetrain.dynamics.support.stiffness - std::abs(rpm - 2000.0);
  if (rpm > 2900.0) point.status = "no balance";
  return point;
}

MotionPlan small_plan() {
  return {.speed_rpm = {1000.0, 2000.0, 3000.0},
          .alternatives = {{"twice", "support.stiffness", {"support.stiffness=10e8 N/m"}}}};
}

std::vector<ChangeResult> computed(std::vector<std::string>& lines, int jobs = 1) {
  const MotionPlan plan = small_plan();
  ChangeStudy study = study_of(shipped(), plan, jobs);
  study.evaluate = made_up;
  return results_of(shipped(), with_reference(plan.alternatives), study,
                    [&](const std::vector<ChangeResult>& results, std::size_t done) {
                      lines.push_back(motion_line(plan, results.front(), results[done - 1]));
                    });
}

nlohmann::ordered_json row(const std::vector<ChangeResult>& results, std::size_t reading) {
  Record record;
  describe_reading(record, "case", small_plan(), results.front(), results[reading]);
  return json_of(record);
}

TEST(SensitivityInMotion, IsTheChangeAtTheBestSpeedOfTheCaseAsItStands) {
  std::vector<std::string> lines;
  const std::vector<ChangeResult> results = computed(lines);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_NEAR(life_of(results[0].points[0]), -500.0, 1e-6);
  EXPECT_NEAR(life_of(results[0].points[1]), 500.0, 1e-6);
  EXPECT_NEAR(life_of(results[1].points[1]), 1000.0, 1e-6);
  EXPECT_EQ(best_point(results[1]), 1U);
  EXPECT_EQ(row(results, 1)["best_speed_rpm"], 2000.0);
  EXPECT_NEAR(row(results, 1)["worth_h"].get<double>(), 500.0, 1e-6);
  EXPECT_EQ(row(results, 0)["settings"].size(), 0U);
}

TEST(SensitivityInMotion, TellsEachChangeInItsOrderWhenItIsDone) {
  for (const int jobs : {1, 2}) {
    std::vector<std::string> lines;
    computed(lines, jobs);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_THAT(lines[0], HasSubstr("the case as it stands"));
    EXPECT_THAT(lines[1], HasSubstr("+500  twice"));
  }
}

TEST(SensitivityInMotion, KeepsPointsThatFailApart) {
  std::vector<std::string> lines;
  const std::vector<ChangeResult> results = computed(lines);
  EXPECT_TRUE(std::isnan(life_of(results[0].points[2])));
  EXPECT_EQ(results[0].points[2].status, "no balance");
  EXPECT_THAT(lines[0], HasSubstr("failed"));
  EXPECT_TRUE(row(results, 0)["points"][2]["life_h"].is_null());
}

TEST(MotionPlan, OfTheReducerIsRead) {
  const ExpectedFile expected = read_expected(expected_beside(shipped_path()));
  ASSERT_TRUE(expected.motion.has_value());
  EXPECT_EQ(expected.motion->fidelity, "monolithic");
  for (const NamedChange& alternative : expected.motion->alternatives)
    EXPECT_NO_THROW(with_settings(shipped(), alternative.settings)) << alternative.name;
}

}  // namespace
}  // namespace orbearing::app::sensitivity_test
