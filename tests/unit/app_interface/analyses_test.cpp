// Analyses as functions of cases: they give the numbers that the command line prints, and its warnings.
#include "orbearing/analyses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "orbearing/errors.hpp"
#include "orbearing/machines.hpp"
#include "orbearing/sweep.hpp"
#include "tests/messages.hpp"
#include "tests/unit/app_interface/shipped_case.hpp"

namespace orbearing {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

Case industrial(const std::vector<std::string>& settings = {}) {
  return Case::read(ORBEARING_SOURCE_DIR "/cases/templates/industrial.yaml", settings);
}

double column(const Points& points, const std::string& name, std::size_t row = 0) {
  const auto at = std::ranges::find(points.columns, name);
  const std::size_t number =
      row * points.columns.size() + static_cast<std::size_t>(at - points.columns.begin());
  return points.numbers.at(number);
}

constexpr double kDigits = 1e-13;  // that a table in other units leaves

TEST(Analyses, OfAPointGiveTheNumbersOfATable) {
  const Case stated = industrial();
  const Warned<OperatingPoint> found = quasi_static(stated);
  const double speed = stated.number("input.speed");
  const Points table = evaluate(stated, {"input.speed"}, {speed});
  EXPECT_NEAR(found.result.tangential_load / column(table, "tangential_load_N"), 1.0, kDigits);
  EXPECT_NEAR(found.result.rating.hours.modified_reference / column(table, "L10mrh"), 1.0, kDigits);
  EXPECT_EQ(found.result.governing_life_hours, found.result.rating.hours.modified_reference);
  EXPECT_FALSE(found.result.distribution.angle.empty());
}

TEST(Analyses, OfAPointWarn) {
  const Warned<OperatingPoint> found = quasi_static(industrial({"gearset.profile_shift.sun=-0.7"}));
  EXPECT_THAT(found.warnings, Contains(HasSubstr("the sun is undercut")));
}

TEST(Analyses, InMotionHaveSlipAndLosses) {
  const Case stated = shipped(
      "reducer_150kW",
      {"simulation.observed_revolutions=1", "simulation.most_revolutions=2", "gearset.mesh_variation=false"});
  const Warned<OperatingPoint> found = in_motion(stated);
  ASSERT_TRUE(found.result.dynamic);
  EXPECT_GT(found.result.dynamic->loss.total(), 0.0);
  EXPECT_GT(found.result.governing_life_hours, 0.0);
}

TEST(Analyses, SayWhereAPointIsNoMachine) {
  EXPECT_THAT(quasi_static(industrial({"input.power=1e7 kW"})).result.status, StartsWith("implausible"));
}

TEST(Sweeps, FindTheLongestLife) {
  const Case stated = industrial();
  const Warned<Sweep> found = sweep(stated, {.speeds = {1000 * rpm, 2000 * rpm, 3000 * rpm}, .jobs = 1});
  const Sweep& curve = found.result;
  EXPECT_EQ(curve.life, "L10mrh");
  ASSERT_EQ(curve.points.size(), curve.governing_life_hours.size());
  ASSERT_TRUE(curve.longest_lived);
  EXPECT_EQ(curve.governing_life_hours[*curve.longest_lived], std::ranges::max(curve.governing_life_hours));
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Points alone = evaluate(stated, {"input.speed"}, {curve.points[i].input_speed});
    EXPECT_NEAR(curve.governing_life_hours[i] / column(alone, "L10mrh"), 1.0, kDigits);
  }
}

TEST(Sweeps, OfTheGridAloneHaveItsPoints) {
  const Warned<Sweep> found =
      sweep(industrial(), {.speeds = {1000 * rpm, 3000 * rpm}, .grid_alone = true, .jobs = 1});
  ASSERT_EQ(found.result.points.size(), 2u);
  EXPECT_DOUBLE_EQ(found.result.points[0].input_speed, 1000 * rpm);
  EXPECT_DOUBLE_EQ(found.result.points[1].input_speed, 3000 * rpm);
}

TEST(Sweeps, WithoutSpeedsAreThoseOfTheCase) {
  const Case stated = industrial({"sweep.input.power=[20 kW, 30 kW]"});
  const Sweep curve = sweep(stated, {.grid_alone = true, .jobs = 1}).result;
  EXPECT_EQ(curve.points.size() % 2, 0u);
  EXPECT_THAT(sweep(stated, {.speeds = {1000 * rpm, 2000 * rpm}, .grid_alone = true}).result.points.size(),
              2u);
}

TEST(Sweeps, OfImpossibleSpeedsAreRefused) {
  EXPECT_THROW(sweep(industrial(), {.speeds = {-1.0}}), BadInput);
  EXPECT_THROW(sweep(industrial(), {.speeds = {1000 * rpm, 1000 * rpm}}), BadInput);
}

TEST(Analyses, OfSingleBearings) {
  const analysis::BearingUnderLoad rollers = under_load(shipped("harris_209"));
  EXPECT_GT(rollers.lundberg_palmgren.bearing, 0.0);
  const analysis::BearingUnderLoad balls = under_load(shipped("jones_218"));
  EXPECT_GT(balls.state.largest_pressure, 1e8);
}

TEST(Analyses, OfGears) {
  const analysis::MeshStudy pair = mesh(shipped("mesh_62_62"));
  ASSERT_EQ(pair.meshes.size(), 1u);
  EXPECT_EQ(pair.gears.size(), 2u);
  EXPECT_GT(mesh(shipped("reducer_150kW")).meshes.size(), 2u);
  EXPECT_FALSE(modes(shipped("lin_parker_1999")).result.modes.empty());
}

// The profile with the longest life lives at least as long as any other, and relieved ends lower the
// pressure.
TEST(Analyses, OfCrownsRecommendAProfile) {
  const Crowning found = crown(industrial(), 1).result;
  EXPECT_GT(found.recommended.drop, 0.0);
  EXPECT_GE(found.longest_lived.life_hours, found.by_standard.life_hours);
  EXPECT_GE(found.longest_lived.life_hours, found.straight.life_hours);
  EXPECT_LT(found.recommended.peak_pressure, found.straight.peak_pressure);
}

TEST(Analyses, RefuseOtherMachines) {
  const Case bearing = shipped("harris_209");
  EXPECT_THROW(quasi_static(bearing), BadInput);
  EXPECT_THROW(sweep(bearing), BadInput);
  EXPECT_THROW(modes(bearing), BadInput);
  EXPECT_THROW(mesh(bearing), BadInput);
  EXPECT_THROW(crown(bearing), BadInput);
  EXPECT_REFUSED(BadInput, "analyses under load", under_load(parsed("reducer_150kW")));
}

}  // namespace
}  // namespace orbearing
