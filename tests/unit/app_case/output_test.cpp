// Output of a case: the resolved case, its hash, the table of `check` and the schema.
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/case/check_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/schema.hpp"
#include "app/results/record_writers.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::output_test {
namespace {

using testing::HasSubstr;

void expect_round_trip(const ResolvedCase& resolved) {
  const std::string text = write_resolved(resolved);
  const ResolvedCase again = parse_case(text, "again.yaml");
  EXPECT_TRUE(again == resolved) << text;
  EXPECT_EQ(write_resolved(again), text);
  EXPECT_EQ(case_hash(again), case_hash(resolved));
}

TEST(ResolvedCase, ReadsBackTheSame) {
  expect_round_trip(shipped());
  expect_round_trip(parse_case(bearing_case, "case.yaml"));
  expect_round_trip(
      shipped({"bearing.radial_clearance=-0.1e1 \xC2\xB5m",
               "assumed.bearing.rollers=\"a\\tb: 'c' \\\"d\\\"\"", "name=not: a [list # or comment",
               "sweep.input.power=[75 kW, 1.5e2 kW]", "sweep.bearing.rollers={from: 13, to: 15, step: 2}"}));
}

TEST(ResolvedCase, SpellsOutDefaultsAndKeepsTextsAsWritten) {
  const std::string text = write_resolved(parse_case(bearing_case, "case.yaml"));
  EXPECT_THAT(text, HasSubstr("radial_clearance: 40.6 um\n"));
  EXPECT_THAT(text, HasSubstr("life:\n  reduction_factor: 0.83\n"));
  EXPECT_THAT(text, HasSubstr("  life.reduction_factor: \"default: "));
}

TEST(ResolvedCase, HashFollowsEveryValue) {
  EXPECT_EQ(case_hash(shipped()).size(), 16U);
  EXPECT_NE(case_hash(shipped()), case_hash(shipped({"input.power=150.0 W"})));
  EXPECT_NE(case_hash(shipped()), case_hash(shipped({"sweep.input.speed.step=500 rpm"})));
  EXPECT_EQ(case_hash(shipped()), case_hash(shipped({"input.power=150 kW"})));
}

TEST(ResolvedCase, QuotesWhatIsNotPlain) {
  EXPECT_EQ(write_scalar("3 mm"), "3 mm");
  EXPECT_EQ(write_scalar("-5 um"), "-5 um");
  EXPECT_EQ(write_scalar("- 5"), "\"- 5\"");
  EXPECT_EQ(write_scalar("a: b"), "\"a: b\"");
  EXPECT_EQ(write_scalar(""), "\"\"");
}

TEST(CheckTable, TellsGivenAssumedAndDerived) {
  const std::vector<Derived> derived{{"gearset.centre_distance", 87.8912, "mm", "working"}};
  const std::string table = check_table(shipped({"input.power=75 kW"}), derived);
  EXPECT_THAT(table, testing::ContainsRegex("input.power +75 +kW +given +set by an option\n"));
  EXPECT_THAT(table, testing::ContainsRegex("bearing.radial_clearance +0 +um +assumed +the printed raceway"));
  EXPECT_THAT(table, testing::ContainsRegex("inertia.euler +true +assumed +default: "));
  EXPECT_THAT(table, testing::ContainsRegex("gearset.centre_distance +87.8912 +mm +derived +working\n"));
  EXPECT_THAT(table, testing::ContainsRegex("pressure_viscosity +1.5e-8 +Pa-1 "));
}

TEST(CheckTable, GivesJsonInSi) {
  Record record;
  describe_check(record, shipped(), {{"a.b", 2.0, "mm", "c"}});
  const nlohmann::ordered_json json = json_of(record);
  EXPECT_EQ(json["name"], "reducer_150kW");
  EXPECT_EQ(json["derived"][0]["value"], 2.0);
  for (const nlohmann::ordered_json& input : json["inputs"]) {
    if (input["path"] != "gearset.module") continue;
    EXPECT_EQ(input["value"], 3e-3);
    EXPECT_EQ(input["unit"], "m");
    EXPECT_EQ(input["standing"], "given");
  }
}

TEST(Schema, IsTheOneShipped) {
  const std::string path = ORBEARING_SOURCE_DIR "/cases/case.schema.json";
  if (std::getenv("ORBEARING_WRITE_SCHEMA") != nullptr) std::ofstream(path) << case_schema();
  EXPECT_EQ(case_schema(), text_of(path)) << "to regenerate it see cases/README.md";
}

TEST(Schema, KnowsEveryFieldOfAModel) {
  const nlohmann::json schema = nlohmann::json::parse(case_schema());
  const nlohmann::json& bearing = schema["$defs"]["roller-bearing"]["properties"]["bearing"];
  EXPECT_EQ(bearing.at("properties").at("rollers").at("minimum"), 3);
  EXPECT_FALSE(bearing.at("properties").contains("per_planet"));
  EXPECT_EQ(bearing.at("additionalProperties"), false);
}

}  // namespace
}  // namespace orbearing::app::output_test
