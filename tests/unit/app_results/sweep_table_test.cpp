#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/results/progress.hpp"
#include "app/results/sweep_table.hpp"
#include "bearing/motion/snapshot.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::sweep_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<SweepRow> fake_rows(std::size_t count) {
  std::vector<SweepRow> rows;
  for (std::size_t i = 0; i < count; ++i) {
    analysis::PointResult result = fake_sweep::fake_result(i == fake_sweep::failing_point ? 0 : i);
    result.input_speed = fake_sweep::input_speed_of(i);
    if (i == fake_sweep::failing_point) result.status = "no balance";
    rows.push_back(sweep_row(result, {}));
  }
  return rows;
}

TEST(PeakText, TellsThePeakAndWhichPointsHaveNoLife) {
  const std::vector<SweepRow> rows = fake_rows(60);
  LifePeak peak = grid_peak({}, rows);
  peak.refined_life_h = 50000.0;
  peak.refined_speed_rpm = 1050.4;
  EXPECT_EQ(peak_text({}, rows, peak),
            "1 of 60 points have no life\nlongest life: 50000 h at 1050.4 rpm; of the grid's points " +
                fmt::format("{:.5g} h at {:g} rpm\n", peak.life_h, peak.speed_rpm));
}

TEST(PeakText, OnePointOrNoneIsReportedInWords) {
  EXPECT_THAT(peak_text({}, fake_rows(1), grid_peak({}, fake_rows(1))),
              ::testing::StartsWith("longest life: "));
  EXPECT_EQ(peak_text({}, {}, {}), "longest life: no point has one\n");
}

TEST(SweepTable, ShowsUnitsAndTheReasonOfAFailure) {
  const std::string table = sweep_table({}, fake_rows(12));
  EXPECT_THAT(table, HasSubstr("planet load"));
  EXPECT_THAT(table, HasSubstr("[Mrev]"));
  EXPECT_THAT(table, HasSubstr("no balance"));
  EXPECT_THAT(table, Not(HasSubstr("one row in")));
}

TEST(SweepTable, AddedPointsAreMarkedAndOfManyThePeakIsShown) {
  const ManifestHeader header{.resonances = true};
  std::vector<SweepRow> rows = fake_rows(60);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].refined = i % 5 != 0;
    rows[i].resonance = Resonance{"planet", "P1", 5093.5, 2, 635.0};
  }
  const std::string few = sweep_table(header, {rows.begin(), rows.begin() + 7});
  EXPECT_THAT(few, HasSubstr("added"));
  EXPECT_THAT(few, HasSubstr("2 x P1 at 6064 rpm"));
  const std::string many = sweep_table(header, rows);
  EXPECT_THAT(many,
              HasSubstr("47 points added around the peak are not shown; all of them stand in sweep.csv"));
  EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 12 + 1 + 3) << many;
}

TEST(SweepTable, LongSweepIsThinnedAndSaysSo) {
  const std::string table = sweep_table({}, fake_rows(481));
  EXPECT_LE(std::count(table.begin(), table.end(), '\n'), 51);
  EXPECT_THAT(table, HasSubstr("one row in 11 of 481"));
}

TEST(Progress, TellsDoneLeftAndTimeToGo) {
  EXPECT_EQ(progress_text(30, 10, 100, 40.0), "30 of 100 points done, 70 left, 2:20 to go");
  EXPECT_EQ(progress_text(10, 0, 1010, 40.0), "10 of 1010 points done, 1000 left, 1:06:40 to go");
  EXPECT_EQ(progress_text(10, 10, 100, 40.0), "10 of 100 points done, 90 left");
  // Unequal points count by their work: a quarter of it took 40 s.
  EXPECT_EQ(progress_text(30, 10, 100, 40.0, 0.25), "30 of 100 points done, 70 left, 2:00 to go");
  EXPECT_EQ(progress_text(100, 10, 100, 40.0), "100 of 100 points done, 0 left");
}

// Each in the unit of its name: a turn a second is 60 rpm, and 2 pi are 360 degrees.
TEST(Progress, TellsTheMotionOfTheBearing) {
  constexpr double turn = constants::two_pi;
  bearing::motion::Snapshot moved;
  moved.orbit_speed = 2.0 * turn;
  moved.orbit_angle = 3.0 * turn;
  moved.cage_position << 2e-6, -3e-6;
  moved.angle = Eigen::Array2d(0.25 * turn, 0.5 * turn);
  moved.spin = Eigen::Array2d(5.0 * turn, -6.0 * turn);
  moved.inner.load = Eigen::Array2d(100.0, 200.0);
  moved.outer.load = Eigen::Array2d(150.0, 250.0);
  const system::MotionProgress now{.time = 0.12,
                                   .most = 1.2,
                                   .expected = 0.48,
                                   .rolling_cage_speed = 4.0 * turn,
                                   .bearing = moved,
                                   .run = 2,
                                   .most_runs = 8};
  const nlohmann::ordered_json expected = nlohmann::ordered_json::parse(
      R"({"time_s": 0.12, "expected_s": 0.48, "most_s": 1.2, "share": 0.25, "seconds_left": 9.5, "run": 2,
          "most_runs": 8, "rolling_cage_rpm": 240.0, "cage_rpm": 120.0, "cage_turned_deg": 1080.0,
          "cage_um": [2.0, -3.0], "angle_deg": [90.0, 180.0], "spin_rpm": [300.0, -360.0],
          "inner_load_N": [100.0, 200.0], "outer_load_N": [150.0, 250.0]})");
  const nlohmann::ordered_json found = motion_json(now, 9.5).flatten(), wanted = expected.flatten();
  ASSERT_EQ(found.size(), wanted.size());
  for (const auto& [key, value] : wanted.items()) {
    ASSERT_TRUE(found.contains(key)) << key;
    EXPECT_DOUBLE_EQ(found.at(key).get<double>(), value.get<double>()) << key;
  }
}

// Progress of one system in motion: simulated time, share and time left.
TEST(Progress, TellsTimeShareAndTimeToGoOfAMotion) {
  const bearing::motion::Snapshot bearing;
  system::MotionProgress now{.time = 0.12, .most = 1.2, .expected = 0.48, .bearing = bearing};
  EXPECT_EQ(motion_text(now, std::nullopt), "0.12 s of 0.48 s in motion, 25 %");
  EXPECT_EQ(motion_json(now, 9.5).at("share"), 0.25);
  EXPECT_EQ(motion_json(now, 9.5).at("seconds_left"), 9.5);
  EXPECT_TRUE(motion_json(now, std::nullopt).at("seconds_left").is_null());
  now.run = 2;
  now.most_runs = 8;
  EXPECT_EQ(motion_text(now, 9.6), "run 2 of at most 8: 0.12 s of 0.48 s in motion, 25 %, 0:10 to go");
  EXPECT_EQ(share_text(0.2, 0.5, 30.0), "0.1 s of 0.5 s in motion, 20 %, 2:00 to go");
  EXPECT_EQ(share_text(0.0, 0.5, 30.0), "0 s of 0.5 s in motion, 0 %");
}

TEST(Progress, PaceIsThatOfEachMotion) {
  const bearing::motion::Snapshot bearing;
  Pace pace;
  const auto at = [&](double time, double rolling) {
    return system::MotionProgress{
        .time = time, .most = 1.0, .expected = 0.5, .rolling_cage_speed = rolling, .bearing = bearing};
  };
  EXPECT_FALSE(seconds_left(pace, at(0.1, 10.0)));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const bool slept =
      *seconds_left(pace, at(0.2, 10.0)) >= 0.06;  // at least 0.02 s for 0.1 s, of 0.3 s that are left
  EXPECT_TRUE(slept);
  EXPECT_EQ(*seconds_left(pace, at(0.5, 10.0)), 0.0);
  EXPECT_FALSE(seconds_left(pace, at(0.3, 10.0))) << "another motion, as its time is earlier";
  EXPECT_FALSE(seconds_left(pace, at(0.4, 20.0))) << "another one, as it rolls at another speed";
}

}  // namespace
}  // namespace orbearing::app::sweep_table_test
