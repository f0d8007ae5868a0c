// Branches, the line of speeds that is shown, and points that start from a given state, on the shipped
// reducer.
#include "app/study/report_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/operating_point.hpp"

namespace orbearing::app::branches_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ResolvedCase reducer(const std::vector<std::string>& settings) {
  return read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

Branch branch(const std::string& folder, std::optional<Direction> direction) {
  Manifest manifest;
  manifest.header = {"reducer", "0123456789abcdef", "0.1.0", "x86-64", "dynamic",
                     1,         std::nullopt,       {},      {},       direction};
  manifest.entries[0].row = row_of_numbers({{"outer_load_rms_N", 2.5}}, *manifest.header);
  return {folder, manifest};
}

std::vector<std::string> refusals(const Branch& one, const Branch& other) {
  try {
    require_two_branches(one, other);
  } catch (const BadInput& error) {
    return error.messages;
  }
  return {};
}

TEST(Branches, OnlyTheDirectionMayDiffer) {
  const Branch up = branch("a", Direction::up);
  EXPECT_THAT(refusals(up, branch("b", Direction::down)), IsEmpty());
  EXPECT_THAT(refusals(up, branch("b", std::nullopt)), IsEmpty());
  EXPECT_THAT(refusals(up, branch("b", Direction::up)),
              Contains(HasSubstr("--with: b: direction of --continue 'up'")));
  Branch other = branch("b", Direction::down);
  other.manifest.header->case_hash = "fedcba9876543210";
  EXPECT_THAT(refusals(up, other), Contains(HasSubstr("hash 'fedcba9876543210' was found")));
}

TEST(Branches, QuasiStaticSweepsHaveNone) {
  Branch one = branch("a", std::nullopt);
  one.manifest.header->fidelity = "quasi-static";
  EXPECT_EQ(refusals(one, one).size(), 2U);
}

TEST(Branches, JsonHoldsEachRunWithItsRowsAndNothingWithoutDirection) {
  const ResolvedCase resolved = reducer({"simulation.load_drift=0.004"});
  EXPECT_TRUE(branches_json(resolved, {branch("a", std::nullopt)}).is_null());
  const nlohmann::ordered_json json =
      branches_json(resolved, {branch("a", Direction::down), branch("b", std::nullopt)});
  EXPECT_EQ(json["load_drift"], 0.004);
  EXPECT_EQ(json["runs"][0]["name"], "down");
  EXPECT_EQ(json["runs"][1]["name"], "own start");
  EXPECT_EQ(json["runs"][1]["points"][0]["outer_load_rms_N"], 2.5);
}

TEST(SpeedSlice, IsTheCaseItselfWithoutASecondAxis) {
  EXPECT_TRUE(speed_slice(reducer({})).columns.is_null());
}

TEST(SpeedSlice, LiesNearestToTheCasesOwnValues) {
  const SpeedSlice slice = speed_slice(reducer(
      {"sweep.input.power=[10 kW, 140 kW, 200 kW]", "sweep.bearing.radial_clearance=[10 um, 37 um]"}));
  EXPECT_EQ(slice.columns.size(), 2U);
  EXPECT_EQ(slice.columns["input.power_kW"], 140.0);
  EXPECT_EQ(slice.columns["bearing.radial_clearance_um"], 10.0);
  EXPECT_EQ(slice.at.quantity("input.power"), 140e3);
}

// Constant mesh forces: means over a cage revolution then repeat, which holds no whole number of mesh
// periods.
analysis::PlanetaryDrivetrain short_run() {
  analysis::PlanetaryDrivetrain drivetrain = drivetrain_of(reducer({"gearset.mesh_variation=false"}));
  drivetrain.steady_state.least_windows = 2;
  drivetrain.steady_state.most_windows = 6;
  drivetrain.steady_state.observed_windows = 1;
  return drivetrain;
}

TEST(EvaluateFrom, RefusesTheStateOfAnotherBearing) {
  const analysis::PlanetaryDrivetrain drivetrain = short_run();
  try {
    analysis::evaluate_from(drivetrain, analysis::derive(drivetrain), Eigen::VectorXd::Zero(79));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("found 79 variables; required: 89, those of 15 rollers"));
  }
}

TEST(EvaluateFrom, StaysInTheSteadyStateItStartsFrom) {
  const analysis::PlanetaryDrivetrain drivetrain = short_run();
  const analysis::DrivetrainGeometry geometry = analysis::derive(drivetrain);
  const analysis::PointResult first = analysis::evaluate(drivetrain, geometry, analysis::Fidelity::dynamic);
  ASSERT_TRUE(first.dynamic->steady);
  const analysis::PointResult second =
      analysis::evaluate_from(drivetrain, geometry, first.dynamic->final_state);
  EXPECT_TRUE(second.dynamic->steady);
  // Two windows of one state differ by no more than the criterion that called them steady.
  EXPECT_NEAR(second.outer.load_rms / first.outer.load_rms, 1.0, drivetrain.steady_state.load_drift);
  EXPECT_EQ(second.planet_load, first.planet_load);
  // It continues where the first ended: rollers have rotated, unlike at a start of its own.
  EXPECT_GT(std::abs(second.dynamic->series.orbit_angle[0]), std::abs(first.dynamic->series.orbit_angle[0]));
}

}  // namespace
}  // namespace orbearing::app::branches_test
