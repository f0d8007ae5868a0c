#include "app/study/validation_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/case/case_file.hpp"
#include "app/study/gear_output.hpp"
#include "tests/gear_sets.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::validation_table_test {
namespace {

using testing::HasSubstr;

ValidationRow row(const std::string& quantity, double published, double ours) {
  return judged({.source = "made up", .quantity = quantity, .published = published, .ours = ours}, false);
}

// Three quantities, one of them a trend and one recomputed, compared under two more readings.
ValidationTable made_up() {
  ValidationTable table{.case_name = "case",
                        .rows = {row("a", 1.0, 1.0), row("b", 2.0, 2.0), row("c", 3.0, 4.0)}};
  table.rows[1] = judged(table.rows[1], true);
  table.rows[2].evidence = Evidence::recomputed;
  for (const char* reading : {"other oil", "other cage"})
    for (ValidationRow again : table.rows) {
      again.reading = reading;
      table.other_readings.push_back(again);
    }
  return table;
}

TEST(ValidationCount, CountsEachPublishedValueOnceWhateverItsReadings) {
  const ValidationCount count = counted({made_up()});
  EXPECT_EQ(count.published, 2);
  EXPECT_EQ(count.trends, 1);
  EXPECT_EQ(count.recomputed, 1);
  EXPECT_EQ(count.comparisons_under_other_readings, 6);
}

TEST(ValidationCount, CountsARowGivenTwiceOnce) {
  ValidationTable twice = made_up();
  twice.rows.push_back(twice.rows.front());
  EXPECT_EQ(counted({twice}).published, 2);
  EXPECT_EQ(counted({twice, made_up()}).published, 2);
}

TEST(ValidationCount, LeavesOutWhatHasNoPublishedNumber) {
  ValidationTable table = made_up();
  table.rows[0].published.reset();
  EXPECT_EQ(counted({table}).published, 1);
}

TEST(ValidationText, ListsOtherReadingsApart) {
  const std::string text = validation_text(made_up());
  const auto apart = text.find("under other readings");
  ASSERT_NE(apart, std::string::npos);
  EXPECT_EQ(text.substr(0, apart).find("other oil"), std::string::npos);
  EXPECT_THAT(text.substr(apart), HasSubstr("4*  other oil"));
  EXPECT_THAT(count_text({made_up()}), HasSubstr("2 distinct published values (1 of them trends)"));
}

// The one source of the reducer prints five things that can be compared; two dozen readings add none.
TEST(ValidationTableOfTheReducer, HasAsManyRowsAsItsSourcePrintsValues) {
  const ExpectedFile expected = read_expected(expected_beside(shipped_path()));
  const ValidationTable table = validation_table_of(shipped(), expected);
  EXPECT_EQ(table.rows.size(), expected.published.size());
  EXPECT_EQ(counted({table}).published, 5);
  EXPECT_EQ(table.other_readings.size(), 5 * expected.alternatives.size());
  EXPECT_EQ(rows_json(table).size(), table.rows.size());
}

TEST(ModeProperty, IsInHertzOrOverThePlanetsOwnFrequency) {
  const ModeStudy study = mode_study(gearset::dynamics::test::lin_parker_model(3));
  const double own = std::sqrt(1e8 / 0.66) / (2.0 * std::numbers::pi);  // [Hz]
  EXPECT_NEAR(mode_property(study, "translational_2_Hz"), 1102.4, 0.1);
  EXPECT_DOUBLE_EQ(mode_property(study, "translational_2_1"),
                   mode_property(study, "translational_2_Hz") / own);
  EXPECT_TRUE(std::isnan(mode_property(study, "planet_1_1")));
}

}  // namespace
}  // namespace orbearing::app::validation_table_test
