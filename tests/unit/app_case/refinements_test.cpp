#include "app/study/fidelity.hpp"

#include <gmock/gmock.h>

#include "app/study/planetary_case.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::refinements_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kWaves = "bearing.outer_race.waviness";

TEST(Refinements, WavesAndDeviationsReachTheBearingInSI) {
  const analysis::PlanetaryDrivetrain drivetrain = drivetrain_of(
      shipped({kWaves + ".order=[2, 11]", kWaves + ".amplitude=[4 um, 0.5 um]",
               kWaves + ".phase=[90 deg, 0 deg]", "bearing.inner_race.out_of_roundness.order=[3]",
               "bearing.inner_race.out_of_roundness.amplitude=[-1 um]",
               "bearing.roller_diameter_deviation=[2 um, -1 um]"}));
  const auto& outer = drivetrain.bearing.outer.form;
  ASSERT_EQ(outer.size(), 2U);
  EXPECT_EQ(outer[1].order, 11);
  EXPECT_DOUBLE_EQ(outer[0].amplitude, 4e-6);
  EXPECT_DOUBLE_EQ(outer[0].phase, M_PI / 2.0);
  EXPECT_TRUE(outer[0].rotating);
  ASSERT_EQ(drivetrain.bearing.inner.form.size(), 1U);
  EXPECT_FALSE(drivetrain.bearing.inner.form[0].rotating);
  EXPECT_EQ(drivetrain.bearing.inner.form[0].phase, 0.0);
  ASSERT_EQ(drivetrain.bearing.rollers().diameter_deviation.size(), 2U);
  EXPECT_DOUBLE_EQ(drivetrain.bearing.rollers().diameter_deviation[1], -1e-6);
}

TEST(Refinements, ChoicesReachTheModel) {
  using namespace bearing::motion;
  const analysis::PlanetaryDrivetrain drivetrain =
      drivetrain_of(shipped({"contact.lubrication=mixed", "contact.roughness=0.3 um",
                             "bearing.cage.pocket_film=hydrodynamic", "input.acceleration=6000 rpm/s"}));
  EXPECT_EQ(drivetrain.dynamics.race.lubrication, Lubrication::mixed);
  EXPECT_DOUBLE_EQ(drivetrain.dynamics.race.roughness, 0.3e-6);
  EXPECT_EQ(drivetrain.dynamics.cage.pocket_film, PocketFilm::hydrodynamic);
  EXPECT_NEAR(drivetrain.run_up.acceleration, 200.0 * M_PI, 1e-9);
}

TEST(Refinements, DefaultsAreThoseOfTheLibraries) {
  const analysis::PlanetaryDrivetrain drivetrain = drivetrain_of(shipped());
  const bearing::motion::DynamicsParameters library;
  EXPECT_EQ(drivetrain.dynamics.race.lubrication, library.race.lubrication);
  EXPECT_DOUBLE_EQ(drivetrain.dynamics.race.roughness, library.race.roughness);
  EXPECT_DOUBLE_EQ(drivetrain.dynamics.race.boundary_friction, library.race.boundary_friction);
  EXPECT_DOUBLE_EQ(drivetrain.dynamics.cage.pocket_roughness, library.cage.pocket_roughness);
  EXPECT_TRUE(drivetrain.bearing.outer.form.empty());
  EXPECT_EQ(drivetrain.run_up.acceleration, 0.0);
}

TEST(Refinements, ListsMustFitEachOther) {
  EXPECT_THAT(setting_mistakes({kWaves + ".order=[2, 3]", kWaves + ".amplitude=[1 um]"}),
              ElementsAre(HasSubstr("amplitude: 1 values for 2 waves")));
  EXPECT_THAT(setting_mistakes({kWaves + ".phase=[2 deg]"}), ElementsAre(HasSubstr("waves without order")));
  EXPECT_THAT(setting_mistakes({kWaves + ".order=[0]", kWaves + ".amplitude=[1 um]"}),
              testing::Contains(HasSubstr("order")));
  EXPECT_THAT(setting_mistakes({"bearing.roller_diameter_deviation=[1 um,1 um,1 um,1 um,1 um,1 um,1 um,1 um,"
                                "1 um,1 um,1 um,1 um,1 um,1 um,1 um,1 um]"}),
              ElementsAre(HasSubstr("16 values; at most one for each of the 15 rollers")));
}

std::string refusal(const std::vector<std::string>& settings, const std::string& fidelity, bool sweep) {
  try {
    require_computable(shipped(settings), fidelity, sweep);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(Refinements, WhatAComputationCannotTakeIsRefused) {
  const std::vector<std::string> run_up = {"input.acceleration=100 rpm/s"};
  EXPECT_EQ(refusal(run_up, "dynamic", false), "");
  EXPECT_THAT(refusal(run_up, "dynamic", true), HasSubstr("--set: input.acceleration: found 100 rpm/s"));
  EXPECT_THAT(refusal(run_up, "quasi-static", false), HasSubstr("input.acceleration"));
  EXPECT_THAT(refusal({"bearing.roller_diameter_deviation=[1 um]"}, "quasi-static", true),
              HasSubstr("cannot take into account"));
  EXPECT_THAT(refusal({kWaves + ".order=[2]", kWaves + ".amplitude=[1 um]"}, "quasi-static", false),
              HasSubstr("waviness.amplitude: '[1 um]', which --fidelity quasi-static cannot"));
  EXPECT_EQ(refusal({kWaves + ".order=[2]", kWaves + ".amplitude=[1 um]"}, "dynamic", true), "");
  EXPECT_EQ(refusal({}, "quasi-static", true), "");
}

}  // namespace
}  // namespace orbearing::app::refinements_test
