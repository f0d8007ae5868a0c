#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/results/progress.hpp"
#include "app/results/terminal_chart.hpp"
#include "bearing/motion/snapshot.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::terminal_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<ResultRow> fake_rows(std::size_t count) {
  std::vector<ResultRow> rows;
  for (std::size_t i = 0; i < count; ++i) {
    study::PointResult result = fake_sweep::fake_result(i == fake_sweep::failing_point ? 0 : i);
    result.input_speed = fake_sweep::input_speed_of(i);
    if (i == fake_sweep::failing_point) result.status = "no balance";
    rows.push_back(result_row(result, {}));
  }
  return rows;
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

TEST(Canvas, BrailleDotsStandWhereTheyAreSet) {
  Canvas canvas(2, 1, Glyphs::braille);
  canvas.dot(0, 0);  // lower left: dot 7
  canvas.dot(3, 3);  // upper right of the second character: dot 4
  canvas.dot(4, 0);  // outside
  EXPECT_EQ(canvas.lines(), std::vector<std::string>{"\u2840\u2808"});
}

TEST(Canvas, LineJoinsItsEndsWithoutGaps) {
  Canvas canvas(5, 3, Glyphs::ascii);
  canvas.line(0, 0, 4, 2);
  EXPECT_EQ(canvas.lines(), (std::vector<std::string>{"   ..", " ..  ", ".    "}));
}

TEST(Canvas, MarkStandsInPlaceOfDots) {
  Canvas canvas(2, 1, Glyphs::ascii);
  canvas.dot(1, 0);
  canvas.mark(1, 0, "O");
  EXPECT_EQ(canvas.lines(), std::vector<std::string>{" O"});
}

TEST(LifeChart, LabelsItsAxesAndTellsThePeak) {
  const std::vector<ResultRow> rows = fake_rows(60);
  const TableHead head = table_head({});
  LifePeak peak = grid_peak(head, rows);
  peak.refined_life_h = 50000.0;
  peak.refined_speed_rpm = 1050.4;
  const std::string chart = life_chart(head, rows, peak, Glyphs::braille);
  for (const char* part :
       {"life [h]", "[rpm]", "1000", "●", "longest life: 50000 h at 1050.4 rpm; of the grid's",
        "1 of 60 points have no life and are not shown"})
    EXPECT_THAT(chart, HasSubstr(part));
}

// The line that a tick's label is on is the one where a life of as many hours is drawn.
TEST(LifeChart, LabelsAreOnTheLinesOfTheirLives) {
  std::vector<ResultRow> rows;
  for (const double life : {10000.0, 1000.0, 100.0}) {
    study::PointResult result = fake_sweep::fake_result(0);
    result.input_speed = fake_sweep::input_speed_of(100 * rows.size());
    result.life_hours = life;
    rows.push_back(result_row(result, {}));
  }
  const TableHead head = table_head({});
  std::istringstream chart(life_chart(head, rows, grid_peak(head, rows), Glyphs::ascii));
  std::string line;
  std::getline(chart, line);  // the name of the axis
  std::getline(chart, line);
  EXPECT_THAT(line, HasSubstr("10000 +O")) << "the longest life, at the lowest speed";
  for (int passed = 0; std::getline(chart, line) && line.find(" 1000 +") == std::string::npos;)
    ASSERT_LT(++passed, 40);
  const std::size_t axis = line.find('+'), dot = line.find('.', axis);
  ASSERT_NE(dot, std::string::npos) << line;
  const std::size_t middle = axis + (line.size() > axis ? 1 : 0);
  EXPECT_GT(dot, middle + 20) << "half way from the lowest speed to the highest";
}

TEST(LifeChart, PlainOneNeedsNoUnicode) {
  const std::vector<ResultRow> rows = fake_rows(60);
  const TableHead head = table_head({});
  const std::string chart = life_chart(head, rows, grid_peak(head, rows), Glyphs::ascii);
  EXPECT_TRUE(is_ascii(chart));
  EXPECT_THAT(chart, HasSubstr("O"));
}

TEST(LifeChart, EverySpeedOfOneSweepFitsTheDrawing) {
  for (const std::size_t count : {2U, 3U, 12U, 500U}) {
    const std::vector<ResultRow> rows = fake_rows(count);
    const TableHead head = table_head({});
    const std::string chart = life_chart(head, rows, grid_peak(head, rows), Glyphs::ascii);
    std::istringstream lines(chart);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 90U) << line;
  }
}

TEST(LifeChart, OnePointOrNoneIsReportedInWords) {
  const TableHead head = table_head({});
  EXPECT_THAT(life_chart(head, fake_rows(1), grid_peak(head, fake_rows(1)), Glyphs::ascii),
              ::testing::StartsWith("longest life: "));
  EXPECT_EQ(life_chart(head, {}, {}, Glyphs::ascii), "longest life: no point has one\n");
}

TEST(LifeChart, GlyphsFollowTheLocaleInItsOrder) {
  const auto glyphs = [](const char* all, const char* lang) {
    setenv("LC_ALL", all, 1);
    unsetenv("LC_CTYPE");
    setenv("LANG", lang, 1);
    return glyphs_of_locale();
  };
  EXPECT_EQ(glyphs("C", "de_DE.UTF-8"), Glyphs::ascii);
  EXPECT_EQ(glyphs("", "de_DE.UTF-8"), Glyphs::braille);
  EXPECT_EQ(glyphs("C.utf8", "C"), Glyphs::braille);
  EXPECT_EQ(glyphs("", ""), Glyphs::ascii);
  unsetenv("LC_ALL");
  unsetenv("LANG");
}

TEST(SweepTable, ShowsUnitsAndTheReasonOfAFailure) {
  const std::string table = sweep_table(table_head({}), fake_rows(12));
  EXPECT_THAT(table, HasSubstr("planet load"));
  EXPECT_THAT(table, HasSubstr("[Mrev]"));
  EXPECT_THAT(table, HasSubstr("no balance"));
  EXPECT_THAT(table, Not(HasSubstr("one row in")));
}

TEST(SweepTable, AddedPointsAreMarkedAndOfManyThePeakIsShown) {
  const TableHead head = table_head({}, {}, true);
  std::vector<ResultRow> rows = fake_rows(60);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].refined = i % 5 != 0;
    add_resonance(Resonance{"planet", "P1", 5093.5, 2, 635.0}, rows[i]);
  }
  const std::string few = sweep_table(head, {rows.begin(), rows.begin() + 7});
  EXPECT_THAT(few, HasSubstr("added"));
  EXPECT_THAT(few, HasSubstr("2 x P1 at 6064 rpm"));
  const std::string many = sweep_table(head, rows);
  EXPECT_THAT(many,
              HasSubstr("47 points added around the peak are not shown; all of them stand in sweep.csv"));
  EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 12 + 1 + 3) << many;
}

TEST(SweepTable, LongSweepIsThinnedAndSaysSo) {
  const std::string table = sweep_table(table_head({}), fake_rows(481));
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
  EXPECT_FALSE(pace.seconds_left(at(0.1, 10.0)));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const bool slept =
      *pace.seconds_left(at(0.2, 10.0)) >= 0.06;  // at least 0.02 s for 0.1 s, of 0.3 s that are left
  EXPECT_TRUE(slept);
  EXPECT_EQ(*pace.seconds_left(at(0.5, 10.0)), 0.0);
  EXPECT_FALSE(pace.seconds_left(at(0.3, 10.0))) << "another motion, as its time is earlier";
  EXPECT_FALSE(pace.seconds_left(at(0.4, 20.0))) << "another one, as it rolls at another speed";
}

}  // namespace
}  // namespace orbearing::app::terminal_test
