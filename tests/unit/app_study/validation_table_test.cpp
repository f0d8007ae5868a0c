#include "app/study/validation_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"
#include "app/study/gear_case.hpp"
#include "tests/gear_sets.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::validation_table_test {
namespace {

using testing::HasSubstr;

PublishedValue value(const std::string& quantity, double number, EvidenceKind kind = EvidenceKind::program) {
  return {.source = "[ISO281], Table 1", .kind = kind, .of = "load", .quantity = quantity, .value = number};
}

// Three quantities, one of them a trend and one recomputed, compared under two more readings.
ValidationTable made_up() {
  ValidationTable table{.case_name = "case",
                        .rows = {judged(value("a", 1.0), 1.0), judged(value("b", 2.0), 2.0),
                                 judged(value("c", 3.0, EvidenceKind::recomputed), 4.0)}};
  table.rows[1].published.of = "trend";
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
  EXPECT_EQ(count.sources, 1);
  EXPECT_EQ(count.comparisons_under_other_readings, 6);
}

TEST(ValidationCount, CountsARowGivenTwiceOnce) {
  ValidationTable twice = made_up();
  twice.rows.push_back(twice.rows.front());
  EXPECT_EQ(counted({twice}).published, 2);
  EXPECT_EQ(counted({twice, made_up()}).published, 2);
}

// A value counts once over all cases, by kind of evidence; another number of the same table and the same
// number under other settings are values of their own.
TEST(ValidationCount, CountsAValueOnceOverAllCasesByItsKind) {
  ValidationTable other{.case_name = "other case",
                        .rows = {judged(value("run:/a", 1.0), 1.0),
                                 judged(value("measured", 5.0, EvidenceKind::measurement), 9.0),
                                 judged(value("formula", 6.0, EvidenceKind::closed_form), 6.0)}};
  const ValidationCount count = counted({made_up(), other});
  EXPECT_EQ(count.published, 3);
  EXPECT_EQ(count.recomputed, 2);
  EXPECT_EQ(count.verdicts.at("measurement").at("missed"), 1);
  EXPECT_EQ(count.verdicts.at("closed-form").at("reproduced"), 1);
  EXPECT_EQ(count.verdicts.at("program").at("reproduced"), 2);
  other.rows[0].published.settings = {"a=1"};
  EXPECT_EQ(counted({made_up(), other}).published, 4);
}

TEST(ValidationCount, LeavesOutWhatIsRemembered) {
  ValidationTable table = made_up();
  table.rows[0].published.memory = true;
  const ValidationCount count = counted({table});
  EXPECT_EQ(count.published, 1);
  EXPECT_EQ(count.remembered, 1);
}

TEST(ValidationCount, LeavesOutWhatHasNoPublishedNumber) {
  ValidationTable table = made_up();
  table.rows[0].published.value.reset();
  EXPECT_EQ(counted({table}).published, 1);
}

// Lines that follow from one formula are one value for each bearing and kind of evidence, that of the median
// deviation; other quantities of the case count as before.
TEST(ValidationCount, CountsLinesOfPassingElementsOnceABearing) {
  const auto line = [](double published, double ours, EvidenceKind kind) {
    PublishedValue row = value("run:/defect_Hz", published, kind);
    row.of = "characteristic frequency";
    row.tolerance = 0.015;
    return judged(row, ours);
  };
  ValidationTable table{
      .case_name = "bearing",
      .rows = {line(100.0, 101.0, EvidenceKind::measurement), line(101.0, 101.0, EvidenceKind::measurement),
               line(95.0, 101.0, EvidenceKind::measurement), line(102.0, 102.0, EvidenceKind::program),
               judged(value("slip", 3.0, EvidenceKind::measurement), 3.0)}};
  const ValidationCount count = counted({table});
  EXPECT_EQ(count.published, 3);
  EXPECT_EQ(count.lines_of_one_formula, 2);
  EXPECT_EQ(count.verdicts.at("measurement").at("reproduced"), 2);
  EXPECT_EQ(count.verdicts.at("measurement").count("missed"), 0);
  EXPECT_THAT(count_text({table}), HasSubstr("further lines of passing elements of the same bearings: 2"));
}

TEST(ValidationText, ListsOtherReadingsApart) {
  const std::string text = validation_text(made_up());
  const auto apart = text.find("under other readings");
  ASSERT_NE(apart, std::string::npos);
  EXPECT_EQ(text.substr(0, apart).find("other oil"), std::string::npos);
  EXPECT_THAT(text.substr(apart), HasSubstr("4*  other oil"));
  EXPECT_THAT(count_text({made_up()}),
              HasSubstr("2 distinct published values from 1 sources (1 of them trends, 0 that"));
}

// expected.yaml without a case beside it, of one row with these lines instead of or besides the usual ones.
class ExpectedYaml : public testing::Test {
 protected:
  ExpectedFile read(const std::string& lines) {
    std::ofstream(file_) << "published:\n  - source: \"[ISO281], p. 1\"\n" << lines;
    return read_expected(file_);
  }
  std::string message(const std::string& lines) {
    try {
      read(lines);
      return "";
    } catch (const BadInput& error) {
      return error.what();
    }
  }
  ~ExpectedYaml() override { std::filesystem::remove(file_); }

  const std::string file_ = testing::TempDir() + "expected_of_validation_table_test.yaml";
  const std::string default_ =
      "    of: slip\n    quantity: run:/a/0\n    meaning: m\n    value: 2\n    tolerance: 0.1\n";
};

// A number that is none reproduces nothing, and one of two values is not dropped.
TEST_F(ExpectedYaml, RefusesNumbersThatAreNoneAndKeysThatStandTwice) {
  const std::string kind = "    kind: program\n    of: slip\n    quantity: run:/a/0\n    meaning: m\n";
  EXPECT_EQ(message(kind + "    value: 2\n    tolerance: 0.1\n"), "");
  for (const char* none : {".nan", ".inf", "-.inf", ".NaN", "1e999"}) {
    EXPECT_THAT(message(kind + "    value: " + none + "\n    tolerance: 0.1\n"), HasSubstr(":7:")) << none;
    EXPECT_THAT(message(kind + "    value: 2\n    tolerance: " + none + "\n"), HasSubstr(":8:")) << none;
    EXPECT_NE(message(kind + "    value: 2\n    tolerance: 0.1\n    scatter: " + std::string(none) + "\n"),
              "")
        << none;
  }
  EXPECT_THAT(message(kind + "    value: 2\n    value: 3\n    tolerance: 0.1\n"),
              HasSubstr(":8:5: value: found twice"));
  EXPECT_THAT(message(kind + "    value: 2\n    tolerance: 0.1\npublished: []\n"),
              HasSubstr("published: found twice"));
}

TEST_F(ExpectedYaml, IsReadAsWritten) {
  const PublishedValue one = read(default_ +
                                  "    kind: worked-example\n    scatter: 0.03\n    why: w\n    memory: "
                                  "true\n    fidelity: dynamic\n")
                                 .published.at(0);
  EXPECT_EQ(one.kind, EvidenceKind::worked_example);
  EXPECT_EQ(one.of, "slip");
  EXPECT_EQ(one.scatter, 0.03);
  EXPECT_EQ(one.why, "w");
  EXPECT_TRUE(one.memory);
  EXPECT_EQ(one.fidelity, "dynamic");
  EXPECT_EQ(result_pointer(one.quantity)->command, "run");
  EXPECT_EQ(result_pointer(one.quantity)->pointer, "/a/0");
}

TEST_F(ExpectedYaml, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(message(default_), HasSubstr("kind: found ''"));
  EXPECT_THAT(message(default_ + "    kind: hearsay\n"), HasSubstr("kind: found 'hearsay'"));
  EXPECT_THAT(message(default_ + "    kind: program\n    evidence: recomputed\n"),
              HasSubstr("unknown key evidence"));
  EXPECT_THAT(message("    kind: program\n"), HasSubstr("of: missing"));
  EXPECT_THAT(message(default_ + "    kind: program\n    scatter: -1\n"), HasSubstr("scatter"));
}

ExpectedFile of_quantity(const std::string& quantity) {
  ExpectedFile expected{.published = {value(quantity, 7.0, EvidenceKind::measurement)}};
  return expected;
}

// A command that gives 2 and 3 everywhere, and counts how often it is called.
ResultOf two_and_three(int& calls) {
  return [&calls](const std::string&, const std::string&, const ResolvedCase&) {
    ++calls;
    return nlohmann::ordered_json{{"list", {2, 3}}, {"text", "no number"}, {"nothing", nullptr}};
  };
}

TEST(ValidationTable, ReadsNumbersOfACommandByTheirPointer) {
  int calls = 0;
  const ValidationOptions options{.result_of = two_and_three(calls)};
  ExpectedFile expected = of_quantity("run:/list/1");
  expected.published.push_back(value("run:/list/0", 2.0));
  expected.published.push_back(value("run:/nothing", 2.0));
  const ValidationTable table = validation_table_of(shipped(), expected, options);
  EXPECT_EQ(table.rows.at(0).ours, 3.0);
  EXPECT_EQ(table.rows.at(0).verdict, "missed");
  EXPECT_EQ(table.rows.at(1).verdict, "reproduced");
  EXPECT_EQ(table.rows.at(2).verdict, "input missing");
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(validation_table_of(shipped(), expected).rows.empty());  // without commands
}

TEST(ValidationTable, RefusesAPointerToNoNumber) {
  int calls = 0;
  const ValidationOptions options{.result_of = two_and_three(calls)};
  EXPECT_THROW(validation_table_of(shipped(), of_quantity("run:/list/2"), options), BadInput);
  EXPECT_THROW(validation_table_of(shipped(), of_quantity("run:/text"), options), BadInput);
}

TEST(ValidationTable, MissesWhatCannotBeComputed) {
  const ValidationOptions options{
      .result_of = [](const std::string&, const std::string&, const ResolvedCase&) -> nlohmann::ordered_json {
        throw ComputationFailed("no balance");
      }};
  const ValidationRow row = validation_table_of(shipped(), of_quantity("run:/a"), options).rows.at(0);
  EXPECT_EQ(row.verdict, "missed");
  EXPECT_FALSE(row.ours);
  EXPECT_THAT(row.published.why, HasSubstr("no balance"));
}

// The quantity is the uncertain number itself, so the band is that of its own distribution.
TEST(ValidationTable, HasTheBandOfItsUncertainInputs) {
  const ValidationOptions options{
      .result_of =
          [](const std::string&, const std::string&, const ResolvedCase& resolved) {
            return nlohmann::ordered_json{{"power", resolved.quantity("input.power")}};
          },
      .samples = 400};
  const ResolvedCase uncertain =
      shipped({"uncertain.input.power={normal: {relative_standard_deviation: 0.02}}"});
  const std::optional<ValidationBand> band =
      validation_table_of(uncertain, of_quantity("run:/power"), options).rows.at(0).band;
  ASSERT_TRUE(band);
  // Quartiles and 5 % of the normal distribution: 0.67449 and 1.64485 standard deviations of 3 kW; strata of
  // 1/400.
  constexpr double stratum = 0.02;  // [standard deviations] at most, at these quantiles
  EXPECT_NEAR(band->high_50, 150e3 + 0.67449 * 3e3, stratum * 3e3);
  EXPECT_NEAR(band->low_50, 150e3 - 0.67449 * 3e3, stratum * 3e3);
  EXPECT_NEAR(band->low_90, 150e3 - 1.64485 * 3e3, stratum * 3e3);
  EXPECT_NEAR(band->high_90, 150e3 + 1.64485 * 3e3, stratum * 3e3);
  EXPECT_EQ(band->samples, 400);
  EXPECT_EQ(band->lost, 0);
}

// The one source of the reducer prints five things that can be compared; two dozen readings add none.
TEST(ValidationTableOfTheReducer, HasAsManyRowsAsItsSourcePrintsValues) {
  const ExpectedFile expected = read_expected(expected_beside(shipped_path()));
  const ValidationTable table = validation_table_of(shipped(), expected);
  EXPECT_EQ(table.rows.size(), expected.published.size());
  EXPECT_EQ(counted({table}).published, 5);
  EXPECT_EQ(table.other_readings.size(), 5 * expected.alternatives.size());
  EXPECT_EQ(json_of(record_of(std::vector{table})).at("rows").size(), table.rows.size());
  EXPECT_EQ(table.rows.front().unit, "rpm");
}

TEST(Modes, AreInHertzAndOverThePlanetsOwnFrequency) {
  const ModeStudy study = mode_study(gearset::dynamics::test::lin_parker_model(3));
  EXPECT_NEAR(study.planet_frequency, std::sqrt(1e8 / 0.66) / (2.0 * std::numbers::pi), 1e-9);
  std::vector<double> translational;
  for (const auto& mode : study.modes)
    if (mode.kind == gearset::dynamics::ModeKind::translational) translational.push_back(mode.frequency);
  EXPECT_NEAR(translational.at(1), 1102.4, 0.1);
}

}  // namespace
}  // namespace orbearing::app::validation_table_test
