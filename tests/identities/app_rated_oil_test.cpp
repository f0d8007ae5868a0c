// Life by film and cleanliness in runs and sweeps of a drivetrain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/life/life_modification.hpp"
#include "coupling/analysis/crowning/crown_grid.hpp"
#include "coupling/analysis/multi_stage.hpp"

namespace orbearing::app::app_rated_oil_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

ResolvedCase reducer(const std::vector<std::string>& settings) {
  return read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

analysis::PointResult point(const std::vector<std::string>& settings) {
  return analysis::evaluate(bearing_sets(reducer(settings)), analysis::Fidelity::quasi_static);
}

const std::string kGrade = "lubricant.grade=ISO VG 220", kWarm = "lubricant.temperature=80 degC";

TEST(RatedOil, StandsBesideTheLifeOfLundbergAndPalmgren) {
  const analysis::PointResult plain = point({}), rated = point({kGrade, kWarm, "life.cleanliness=high"});
  EXPECT_FALSE(plain.rating.lives.oil);
  ASSERT_TRUE(rated.rating.lives.oil);
  EXPECT_TRUE(std::isnan(plain.rating.hours.modified) && std::isnan(plain.rating.hours.modified_reference));
  // A dry contact carries the same load whatever the oil.
  EXPECT_EQ(rated.life_hours, plain.life_hours);
  EXPECT_EQ(rated.rating.hours.basic, plain.rating.hours.basic);
  EXPECT_EQ(rated.rating.hours.reference, plain.rating.hours.reference);
  const auto& hours = rated.rating.hours;
  EXPECT_NEAR(hours.modified, rated.rating.lives.life_modification * hours.basic, 1e-9 * hours.modified);
  EXPECT_NEAR(hours.modified_reference, rated.rating.lives.reference_modification * hours.reference,
              1e-9 * hours.modified_reference);
  for (const auto life : bearing::rating::kRatedHours)
    EXPECT_NEAR(rated.rating.system_hours.*life / hours.*life, rated.system_life_hours / rated.life_hours,
                1e-12);
  const ResolvedCase in = reducer({kGrade, kWarm});
  const analysis::PlanetaryDrivetrain set = drivetrain_of(in);
  const auto duty = analysis::bearing_duty(set, analysis::derive(set));
  const double required = bearing::rating::required_viscosity(
      bearing::rotating_speed(set.bearing, duty.point), set.bearing.pitch_diameter);
  EXPECT_NEAR(rated.rating.lives.oil->viscosity_ratio,
              in.quantity("lubricant.kinematic_viscosity") / required, 1e-12);
}

TEST(RatedOil, CodesOfCleanlinessAreLevels) {
  for (const auto& [word, code] : {std::pair{"highest", "-/13/10"}, std::pair{"high", "-/15/12"},
                                   std::pair{"medium", "-/17/14"}, std::pair{"low", "-/19/16"}}) {
    const auto by_word = point({kGrade, "life.cleanliness=" + std::string(word)});
    const auto by_code = point({kGrade, "life.cleanliness=" + std::string(code)});
    EXPECT_EQ(by_word.rating.hours.modified, by_code.rating.hours.modified) << word;
  }
  for (const auto life :
       {&bearing::rating::RatedHours::modified, &bearing::rating::RatedHours::modified_reference})
    EXPECT_GT(point({kGrade, "life.cleanliness=highest"}).rating.hours.*life,
              2.0 * point({kGrade, "life.cleanliness=low"}).rating.hours.*life);
}

TEST(RatedOil, ReliabilityShortensIt) {
  const auto ninety = point({kGrade}), ninety_nine = point({kGrade, "life.reliability=0.99"});
  for (const auto life :
       {&bearing::rating::RatedHours::modified, &bearing::rating::RatedHours::modified_reference})
    EXPECT_NEAR(ninety_nine.rating.hours.*life / ninety.rating.hours.*life,
                bearing::rating::reliability_factor(0.99), 1e-12);
  EXPECT_EQ(ninety_nine.rating.hours.basic, ninety.rating.hours.basic);
  EXPECT_EQ(ninety_nine.rating.hours.reference, ninety.rating.hours.reference);
  EXPECT_EQ(ninety_nine.life_hours, ninety.life_hours);
}

TEST(RatedOil, FilmCanGiveKappa) {
  const auto rated = point({kGrade, kWarm, "life.viscosity_ratio_by=film", "contact.roughness=0.3 um"});
  const double film = std::min(rated.inner.least_film, rated.outer.least_film);
  EXPECT_NEAR(rated.rating.lives.oil->viscosity_ratio, std::pow(film / 0.3e-6, 1.3), 1e-12);
}

TEST(RatedOil, ViscositiesOfTheGradeTakeTheirPositionAndThatIsSaid) {
  const ResolvedCase in = reducer({kGrade, kWarm});
  EXPECT_NE(in.quantity("lubricant.viscosity"), reducer({}).quantity("lubricant.viscosity"));
  EXPECT_NEAR(in.quantity("lubricant.viscosity") / in.quantity("lubricant.kinematic_viscosity"),
              in.quantity("lubricant.density"), 1e-2);
  const std::vector<std::string> warnings = require_used(in, AnalysisId::quasi_static);
  EXPECT_THAT(warnings, Contains(HasSubstr("lubricant.viscosity: 0.01 Pa.s has no effect")));
  EXPECT_THAT(warnings, Contains(HasSubstr("lubricant.pressure_viscosity: 1.5e-8 Pa-1 has no effect")));
  EXPECT_THAT(require_used(reducer({}), AnalysisId::quasi_static), Not(Contains(HasSubstr("lubricant"))));
  EXPECT_THAT(require_used(reducer({kWarm}), AnalysisId::quasi_static),
              Contains(HasSubstr("lubricant.temperature: 80 degC has no effect")));
}

TEST(RatedOil, CleanlinessThatIsNotSaidIsReported) {
  EXPECT_THAT(rating_warnings(reducer({kGrade})),
              Contains(HasSubstr("'high' (-/15/12 of ISO 4406) is taken")));
  EXPECT_THAT(rating_warnings(reducer({kGrade, "life.contamination_factor=0.5"})), testing::IsEmpty());
  EXPECT_THAT(rating_warnings(reducer({})), testing::IsEmpty());
}

// Below 0.1 the standard has no a_ISO: no number rather than a wrong one.
TEST(RatedOil, StarvedBearingsHaveNoModifiedLife) {
  const auto rated =
      point({"lubricant.grade=ISO VG 7", "lubricant.temperature=120 degC", "input.speed=200 rpm"});
  ASSERT_TRUE(rated.rating.lives.oil);
  EXPECT_LT(rated.rating.lives.oil->viscosity_ratio, 0.1);
  EXPECT_TRUE(std::isnan(rated.rating.hours.modified) && std::isnan(rated.rating.hours.modified_reference));
  EXPECT_GT(rated.rating.hours.basic, 0.0);
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
  const analysis::PointResult moving = analysis::evaluate(bearing_sets(in), analysis::Fidelity::dynamic);
  const analysis::PointResult rest = point({kGrade, kWarm});
  const bearing::rating::RatingLives& lives = moving.rating.lives;
  ASSERT_TRUE(lives.oil);
  EXPECT_NEAR(lives.oil->viscosity_ratio, rest.rating.lives.oil->viscosity_ratio, 1e-12);
  // ISO 281 uses the mean load alone.
  EXPECT_NEAR(moving.rating.hours.basic / rest.rating.hours.basic, 1.0, 1e-12);
  EXPECT_NEAR(moving.rating.hours.modified / rest.rating.hours.modified, 1.0, 1e-12);
  // The reference life uses the loads of the motion, as that of Lundberg and Palmgren does: means of the same
  // powers, capacities that differ by factors.
  EXPECT_NEAR(
      (moving.rating.hours.reference / rest.rating.hours.reference) / (moving.life_hours / rest.life_hours),
      1.0, 2e-3);
  EXPECT_NE(moving.rating.hours.reference, rest.rating.hours.reference);
}

TEST(RatedOil, OfSeveralSetsAllCountTogether) {
  const ResolvedCase in = read_point(ORBEARING_SOURCE_DIR "/cases/three_sets_150kW/case.yaml",
                                     {kGrade, kWarm, "life.cleanliness=high"});
  const auto sets = bearing_sets(in);
  const analysis::PointResult all = analysis::evaluate(sets, analysis::Fidelity::quasi_static);
  ASSERT_EQ(all.sets.size(), sets.size());
  ASSERT_GT(sets.size(), 1u);
  for (const auto life : bearing::rating::kRatedHours) {
    double damage = 0.0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const analysis::PlanetaryDrivetrain& set = sets[i].drivetrain;
      damage +=
          set.set.planets * set.bearings_per_planet * std::pow(all.sets[i].rating.hours.*life, -9.0 / 8.0);
    }
    EXPECT_NEAR(all.rating.system_hours.*life / std::pow(damage, -8.0 / 9.0), 1.0, 1e-10);
  }
}

// The crown study rates what a sweep of the same rollers rates.
TEST(RatedOil, CrownsAreRatedAsInASweep) {
  using namespace analysis::crowning;
  const std::vector<std::string> settings{kGrade,
                                          kWarm,
                                          "life.cleanliness=medium",
                                          "bearing.laminae=40",
                                          "bearing.profile.kind=straight",
                                          "bearing.misalignment.planet_tilt=0.3 mrad"};
  const analysis::PointResult swept = point(settings);
  const CrownProblem problem = problem_of(crown_request(reducer(settings), {}));
  const CrownPoint crown =
      crown_grid(problem, RollerPressure(problem), {bearing::profile::Profile{}}, {0.0}, {0.3e-3}, 1, {})
          .front();
  ASSERT_EQ(crown.status, "ok");
  EXPECT_NEAR(crown.life_hours, swept.life_hours, 1e-6 * swept.life_hours);
  for (const auto life : bearing::rating::kRatedHours)
    EXPECT_NEAR(crown.rated_hours.*life / swept.rating.hours.*life, 1.0, 1e-6);
  const CrownProblem unrated = problem_of(crown_request(reducer({}), {}));
  const CrownPoint dry =
      crown_grid(unrated, RollerPressure(unrated), {bearing::profile::Profile{}}, {0.0}, {0.0}, 1, {})
          .front();
  EXPECT_TRUE(std::isnan(dry.rated_hours.modified) && std::isnan(dry.rated_hours.modified_reference));
  EXPECT_GT(dry.rated_hours.reference, 0.0);
}

}  // namespace
}  // namespace orbearing::app::app_rated_oil_test
