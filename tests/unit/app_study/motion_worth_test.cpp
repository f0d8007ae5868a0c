#include "app/study/motion_worth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/study/worth.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::motion_worth_test {
namespace {

using testing::HasSubstr;

constexpr double kRevolutions = 30.0 / 3.14159265358979323846;  // rpm of 1 rad/s

// A stand-in for the motion: life falls away from 2000 rpm, and grows with the pin's stiffness.
study::PointResult made_up(const ResolvedCase& at_speed, study::Fidelity fidelity) {
  EXPECT_EQ(fidelity, study::Fidelity::monolithic);
  study::PointResult point;
  const double rpm = kRevolutions * at_speed.quantity("input.speed");
  point.life_hours = 1e-6 * at_speed.quantity("support.stiffness") - std::abs(rpm - 2000.0);
  if (rpm > 2900.0) point.status = "no balance";
  return point;
}

MotionWorth computed(std::vector<std::string>& lines) {
  const MotionPlan plan{.speed_rpm = {1000.0, 2000.0, 3000.0},
                        .alternatives = {{"support.stiffness", "twice", {"support.stiffness=10e8 N/m"}}}};
  return motion_worth(shipped(), plan, 1, made_up,
                      [&lines](const MotionWorth& so_far) { lines.push_back(motion_line(so_far)); });
}

TEST(MotionWorth, IsTheChangeAtTheBestSpeedOfTheCaseAsItStands) {
  std::vector<std::string> lines;
  const MotionWorth worth = computed(lines);
  ASSERT_EQ(worth.curves.size(), 2U);
  EXPECT_NEAR(worth.curves[0].life_h[0], -500.0, 1e-6);
  EXPECT_NEAR(worth.curves[0].life_h[1], 500.0, 1e-6);
  EXPECT_NEAR(worth.curves[1].life_h[1], 1000.0, 1e-6);
  EXPECT_EQ(best_speed(worth.curves[1]), 1U);
  const auto json = motion_json(worth);
  EXPECT_EQ(json[1]["best_speed_rpm"], 2000.0);
  EXPECT_NEAR(json[1]["worth_h"].get<double>(), 500.0, 1e-6);
  EXPECT_EQ(json[0]["settings"].size(), 0U);
}

TEST(MotionWorth, TellsEachCurveWhenItIsDone) {
  std::vector<std::string> lines;
  computed(lines);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_THAT(lines[0], HasSubstr("the case as it stands"));
  EXPECT_THAT(lines[1], HasSubstr("+500  twice"));
}

TEST(MotionWorth, KeepsPointsThatFailApart) {
  std::vector<std::string> lines;
  const MotionWorth worth = computed(lines);
  EXPECT_TRUE(std::isnan(worth.curves[0].life_h[2]));
  EXPECT_EQ(worth.curves[0].status[2], "no balance");
  EXPECT_THAT(lines[0], HasSubstr("failed"));
  EXPECT_TRUE(motion_json(worth)[0]["points"][2]["life_h"].is_null());
}

TEST(MotionPlan, OfTheReducerIsRead) {
  const ExpectedFile expected = read_expected(expected_beside(shipped_path()));
  ASSERT_TRUE(expected.motion.has_value());
  EXPECT_EQ(expected.motion->fidelity, "monolithic");
  for (const Alternative& alternative : expected.motion->alternatives)
    EXPECT_NO_THROW(with_settings(shipped(), alternative.settings)) << alternative.reading;
}

}  // namespace
}  // namespace orbearing::app::motion_worth_test
