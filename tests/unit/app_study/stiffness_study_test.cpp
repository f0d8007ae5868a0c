// The stiffness as results have it, of bearings over speed and load.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/case/static_case.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/stiffness_study.hpp"

namespace orbearing::app::stiffness_study_test {
namespace {

using testing::HasSubstr;

ResolvedCase shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_case(std::string(ORBEARING_SOURCE_DIR "/cases/") + name + "/case.yaml", settings);
}

TEST(StiffnessStudy, IsThatOfRun) {
  const ResolvedCase in = shipped("jones_218", {"load.radial=2 kN", "load.moment_across=20 N.m"});
  const StiffnessStudy study = stiffness_study(in);
  ASSERT_EQ(study.points.size(), 1u);
  EXPECT_EQ(*study.points[0].stiffness, bearing::equilibrium::stiffness_by_axes(bearing_under_load(in).state));
}

// Loads go outside, speeds inside; each load is a series of its own.
TEST(StiffnessStudy, LoadsAndSpeeds) {
  const StiffnessStudy study = stiffness_study(
      shipped("jones_218", {"operation.speeds=[3000 rpm, 0 rpm]", "operation.load_factors=[2, 0.5]"}));
  ASSERT_EQ(study.points.size(), 4u);
  EXPECT_EQ(study.series, 2u);
  EXPECT_EQ(study.points[0].load[1], std::pair(std::string("axial_N"), 35600.0));
  EXPECT_EQ(study.points[1].speed, 0.0);
  EXPECT_EQ(study.points[2].series, 1u);
  EXPECT_GT((*study.points[1].stiffness)(2, 2), (*study.points[3].stiffness)(2, 2));
}

TEST(StiffnessStudy, APointWithoutBalanceIsNull) {
  StiffnessStudy study = stiffness_study(shipped("jones_218", {"operation.speeds=[0 rpm, 3000 rpm]"}));
  study.points[1].stiffness.reset();
  study.points[1].status = "no balance";
  Record record;
  describe(record, study);
  const nlohmann::ordered_json object = json_of(record);
  EXPECT_TRUE(object["points"][0]["stiffness"][4][4].is_number());
  EXPECT_TRUE(object["points"][1]["stiffness"].is_null());
  EXPECT_TRUE(object["points"][1]["displacement"].is_null());
  EXPECT_EQ(object["points"][1]["status"], "no balance");
  EXPECT_THAT(stiffness_csv(study), HasSubstr(",,,,\"no balance\"\n"));
  EXPECT_THAT(text_of(record), HasSubstr("no balance"));
  for (const NamedArray& array : content_of(record).arrays) {
    if (array.name == "stiffness") {
      EXPECT_TRUE(std::isnan(array.values.back()));
    }
  }
}

// A worksheet begins with the mark by which readers recognise BIFF 4, and ends; a single point is in five
// rows, rising in speed.
TEST(StiffnessStudy, TableForRoss) {
  const StiffnessStudy study = stiffness_study(shipped("jones_218"));
  const std::string sheet = ross_table(study, 0);
  using namespace std::string_literals;
  EXPECT_TRUE(sheet.starts_with("\x09\x04\x06\x00\x00\x00\x10\x00"s));
  EXPECT_TRUE(sheet.ends_with("\x0a\x00\x00\x00"s));
  constexpr std::size_t begin = 10, end = 4, number = 4 + 14, label = 4 + 8;
  const std::size_t letters = 8 * 3 + 5;  // kxx and so on, speed
  const std::string axes = "x is along the load (of a planet: outward), y across; weight in ROSS is along y";
  EXPECT_NE(sheet.find(axes), std::string::npos);
  EXPECT_EQ(sheet.size(), begin + 10 * label + letters + axes.size() + 5 * 9 * number + end);
}

// The bore of a planet bearing at its sweep's points, the two of one bearing of each set apart.
TEST(StiffnessStudy, PlanetsOfSeveralSetsAreSeries) {
  const StiffnessStudy study =
      stiffness_study(shipped("three_sets_150kW", {"sweep.input.speed=[3000 rpm, 6000 rpm]"}));
  EXPECT_EQ(study.points.size(), 2 * study.series);
  EXPECT_GT(study.series, 1u);
  for (const StiffnessPoint& point : study.points) {
    ASSERT_TRUE(point.stiffness) << point.status;
    EXPECT_FALSE(point.set.empty());
    EXPECT_EQ(point.stiffness->row(2).norm(), 0.0);
  }
}

// Straight laminae carry what whole contacts do: tilt apart, the stiffness is that of the contacts.
TEST(StiffnessStudy, LaminaeOfStraightRollersChangeNothing) {
  const auto of = [](const std::vector<std::string>& settings) {
    return *stiffness_study(shipped("reducer_150kW", settings)).points.front().stiffness;
  };
  const bearing::equilibrium::RingStiffness whole = of({}), cut = of({"bearing.laminae=30"}),
                                            finer = of({"bearing.laminae=60"});
  EXPECT_LT((whole - cut).norm(), 1e-12 * whole.norm());
  EXPECT_LT((whole.topLeftCorner<2, 2>() - finer.topLeftCorner<2, 2>()).norm(), 1e-9 * whole.norm());
  EXPECT_NEAR(finer(3, 3) / whole(3, 3), 1.0, 1e-3);
}

}  // namespace
}  // namespace orbearing::app::stiffness_study_test
