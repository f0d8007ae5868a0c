// Issue 16, Build 5: life by film and cleanliness in runs and sweeps of a drivetrain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/rated_oil.hpp"
#include "bearing/life/life_modification.hpp"
#include "coupling/study/crowning/crown_grid.hpp"
#include "coupling/study/multi_stage.hpp"

namespace orbearing::app::app_rated_oil_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

ResolvedCase reducer(const std::vector<std::string>& settings) {
  return read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

study::PointResult point(const std::vector<std::string>& settings) {
  return study::evaluate(bearing_sets(reducer(settings)), study::Fidelity::quasi_static);
}

const std::string kGrade = "lubricant.grade=ISO VG 220", kWarm = "lubricant.temperature=80 degC";

TEST(RatedOil, StandsBesideTheLifeOfLundbergAndPalmgren) {
  const study::PointResult plain = point({}), rated = point({kGrade, kWarm, "life.cleanliness=high"});
  EXPECT_FALSE(plain.modified);
  ASSERT_TRUE(rated.modified);
  // A dry contact carries alike whatever the oil.
  EXPECT_EQ(rated.life_hours, plain.life_hours);
  EXPECT_NEAR(rated.modified->life_hours, rated.modified->life_modification * rated.life_hours,
              1e-9 * rated.modified->life_hours);
  EXPECT_NEAR(rated.modified->system_life_hours / rated.modified->life_hours,
              rated.system_life_hours / rated.life_hours, 1e-12);
  const ResolvedCase in = reducer({kGrade, kWarm});
  const study::PlanetaryDrivetrain set = drivetrain_of(in);
  const auto duty = study::bearing_duty(set, study::derive(set));
  const double required = bearing::rating::required_viscosity(bearing::turning_speed(set.bearing, duty.point),
                                                              set.bearing.pitch_diameter);
  EXPECT_NEAR(rated.modified->viscosity_ratio, in.quantity("lubricant.kinematic_viscosity") / required,
              1e-12);
}

TEST(RatedOil, CodesOfCleanlinessAreLevels) {
  for (const auto& [word, code] : {std::pair{"highest", "-/13/10"}, std::pair{"high", "-/15/12"},
                                   std::pair{"medium", "-/17/14"}, std::pair{"low", "-/19/16"}}) {
    const auto by_word = point({kGrade, "life.cleanliness=" + std::string(word)});
    const auto by_code = point({kGrade, "life.cleanliness=" + std::string(code)});
    EXPECT_EQ(by_word.modified->life_hours, by_code.modified->life_hours) << word;
  }
  EXPECT_GT(point({kGrade, "life.cleanliness=highest"}).modified->life_hours,
            2.0 * point({kGrade, "life.cleanliness=low"}).modified->life_hours);
}

TEST(RatedOil, ReliabilityShortensIt) {
  const auto ninety = point({kGrade}), ninety_nine = point({kGrade, "life.reliability=0.99"});
  EXPECT_NEAR(ninety_nine.modified->life_hours / ninety.modified->life_hours,
              bearing::rating::reliability_factor(0.99), 1e-12);
  EXPECT_EQ(ninety_nine.life_hours, ninety.life_hours);
}

TEST(RatedOil, FilmCanGiveKappa) {
  const auto rated = point({kGrade, kWarm, "life.viscosity_ratio_by=film", "contact.roughness=0.3 um"});
  const double film = std::min(rated.inner.least_film, rated.outer.least_film);
  EXPECT_NEAR(rated.modified->viscosity_ratio, std::pow(film / 0.3e-6, 1.3), 1e-12);
}

TEST(RatedOil, ViscositiesOfTheGradeTakeTheirPlaceAndThatIsSaid) {
  const ResolvedCase in = reducer({kGrade, kWarm});
  EXPECT_NE(in.quantity("lubricant.viscosity"), reducer({}).quantity("lubricant.viscosity"));
  EXPECT_NEAR(in.quantity("lubricant.viscosity") / in.quantity("lubricant.kinematic_viscosity"),
              in.quantity("lubricant.density"), 1e-2);
  const std::vector<std::string> warnings = require_used(in, use::quasi_static);
  EXPECT_THAT(warnings, Contains(HasSubstr("lubricant.viscosity: 0.01 Pa.s has no effect")));
  EXPECT_THAT(warnings, Contains(HasSubstr("lubricant.pressure_viscosity: 1.5e-8 Pa-1 has no effect")));
  EXPECT_THAT(require_used(reducer({}), use::quasi_static), Not(Contains(HasSubstr("lubricant"))));
  EXPECT_THAT(require_used(reducer({kWarm}), use::quasi_static),
              Contains(HasSubstr("lubricant.temperature: 80 degC has no effect")));
}

TEST(RatedOil, CleanlinessThatIsNotSaidIsReported) {
  EXPECT_THAT(oil_warnings(reducer({kGrade})), Contains(HasSubstr("'high' (-/15/12 of ISO 4406) is taken")));
  EXPECT_THAT(oil_warnings(reducer({kGrade, "life.contamination_factor=0.5"})), testing::IsEmpty());
  EXPECT_THAT(oil_warnings(reducer({})), testing::IsEmpty());
}

// Below 0.1 the standard knows no a_ISO: no number rather than a wrong one.
TEST(RatedOil, StarvedBearingsHaveNoModifiedLife) {
  const auto rated =
      point({"lubricant.grade=ISO VG 7", "lubricant.temperature=120 degC", "input.speed=200 rpm"});
  ASSERT_TRUE(rated.modified);
  EXPECT_LT(rated.modified->viscosity_ratio, 0.1);
  EXPECT_TRUE(std::isnan(rated.modified->life_hours));
  EXPECT_GT(rated.life_hours, 0.0);
}

// Said once, and of the oil: it is that of all sets.
TEST(RatedOil, OilsOfWhichNothingIsKnownAreRefused) {
  const std::vector<std::string> thin{"lubricant.grade=ISO VG 7", "lubricant.viscosity_index=0"};
  for (const char* name : {"reducer_150kW", "coupling_set_150kW"}) {
    try {
      read_point(std::string(ORBEARING_SOURCE_DIR "/cases/") + name + "/case.yaml", thin);
      ADD_FAILURE() << name;
    } catch (const std::exception& error) {
      EXPECT_THAT(error.what(), HasSubstr("ISO VG 7; kinematic viscosity at 40 degC"));
      EXPECT_THAT(error.what(), Not(HasSubstr("sets.")));
    }
  }
}

// One planet like the other gives the product law of all bearings; so does motion in time.
TEST(RatedOil, MotionIsRatedByTheSameLaw) {
  const ResolvedCase in = reducer({kGrade, kWarm, "simulation.observed_revolutions=2"});
  const study::PointResult moving = study::evaluate(bearing_sets(in), study::Fidelity::dynamic);
  ASSERT_TRUE(moving.modified);
  EXPECT_NEAR(moving.modified->life_hours, moving.modified->life_modification * moving.life_hours,
              1e-9 * moving.modified->life_hours);
  EXPECT_NEAR(moving.modified->viscosity_ratio, point({kGrade, kWarm}).modified->viscosity_ratio, 1e-12);
}

TEST(RatedOil, OfSeveralSetsAllCountTogether) {
  const ResolvedCase in = read_point(ORBEARING_SOURCE_DIR "/cases/coupling_set_150kW/case.yaml",
                                     {kGrade, kWarm, "life.cleanliness=high"});
  const study::PointResult all = study::evaluate(bearing_sets(in), study::Fidelity::quasi_static);
  ASSERT_TRUE(all.modified);
  EXPECT_LT(all.modified->system_life_hours, all.modified->life_hours);
  for (const study::SetResult& set : all.sets) EXPECT_TRUE(set.modified) << set.set;
}

// The crown study rates what a sweep of the same rollers rates.
TEST(RatedOil, CrownsAreRatedAsInASweep) {
  using namespace study::crowning;
  const std::vector<std::string> settings{kGrade,
                                          kWarm,
                                          "life.cleanliness=medium",
                                          "bearing.laminae=40",
                                          "bearing.profile.kind=straight",
                                          "bearing.misalignment.planet_tilt=0.3 mrad"};
  const study::PointResult swept = point(settings);
  const CrownProblem problem = problem_of(crown_request(reducer(settings), {}));
  const CrownPoint crown =
      crown_grid(problem, RollerPressure(problem), {bearing::profile::Profile{}}, {0.0}, {0.3e-3}, 1, {})
          .front();
  ASSERT_EQ(crown.status, "ok");
  EXPECT_NEAR(crown.life_hours, swept.life_hours, 1e-6 * swept.life_hours);
  EXPECT_NEAR(crown.modified_life_hours, swept.modified->life_hours, 1e-6 * swept.modified->life_hours);
  const CrownProblem unrated = problem_of(crown_request(reducer({}), {}));
  EXPECT_TRUE(std::isnan(
      crown_grid(unrated, RollerPressure(unrated), {bearing::profile::Profile{}}, {0.0}, {0.0}, 1, {})
          .front()
          .modified_life_hours));
}

}  // namespace
}  // namespace orbearing::app::app_rated_oil_test
