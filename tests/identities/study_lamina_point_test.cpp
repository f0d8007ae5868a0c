// Operating points of a drivetrain whose planet bearings are cut into laminae.
#include <gtest/gtest.h>

#include <numeric>

#include "bearing/contact/race_contact.hpp"
#include "coupling/analysis/crowning/crown_problem.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_lamina_point_test {
namespace {

constexpr double kRoundOff = 1e-9;  // of loads and lives, 9/2 times that of the equilibrium

PointResult point(const PlanetaryDrivetrain& drivetrain) {
  return evaluate(drivetrain, derive(drivetrain));
}

PlanetaryDrivetrain crowned(double scale) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.bearing.rollers().laminae = 40;
  drivetrain.bearing.rollers().profile = bearing::profile::Iso16281{5.7e-3, 5.24e-3, scale};
  return drivetrain;
}

TEST(LaminaPoint, StraightAndLevelIsTheUncutPoint) {
  for (const bool film : {false, true}) {
    PlanetaryDrivetrain uncut = example::reducer(), cut = crowned(0.0);
    uncut.dynamics.race.film_in_approach = cut.dynamics.race.film_in_approach = film;
    const PointResult expected = point(uncut), found = point(cut);
    EXPECT_NEAR(found.life_hours, expected.life_hours, kRoundOff * expected.life_hours);
    EXPECT_NEAR(found.inner.load_max, expected.inner.load_max, kRoundOff * expected.inner.load_max);
    EXPECT_NEAR(found.contact_pressure, expected.contact_pressure, kRoundOff * expected.contact_pressure);
    EXPECT_FALSE(expected.laminae.has_value());
  }
}

// The least film of a race is that under its most loaded roller.
TEST(LaminaPoint, HasItsLeastFilmUnderTheLargestLoad) {
  const PlanetaryDrivetrain drivetrain = example::reducer();
  const DrivetrainGeometry geometry = derive(drivetrain);
  const PointResult found = evaluate(drivetrain, geometry);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const bearing::RollerContacts contacts =
      bearing::rolling_contacts(drivetrain.bearing, geometry.bearing, duty.point.inner_speed,
                                duty.point.outer_speed, drivetrain.dynamics.lubricant);
  EXPECT_NEAR(found.inner.least_film / contacts.inner.film().least(found.inner.load_max), 1.0, kRoundOff);
  EXPECT_NEAR(found.outer.least_film / contacts.outer.film().least(found.outer.load_max), 1.0, kRoundOff);
  EXPECT_LT(found.inner.least_film, 0.99 * contacts.inner.film().least(found.inner.load_rms));
}

TEST(LaminaPoint, RecordsTheLaminaeOfEveryPosition) {
  PlanetaryDrivetrain drivetrain = crowned(1.0);
  drivetrain.misalignment = {.planet_tilt = 1e-3};
  const PointResult found = point(drivetrain);
  ASSERT_TRUE(found.laminae.has_value());
  const LaminaRecord& record = *found.laminae;
  const std::size_t positions = found.distribution.angle.size();
  ASSERT_EQ(record.lamina_position.size(), 40U);
  ASSERT_EQ(record.inner_load.size(), 40U * positions);
  ASSERT_EQ(record.roller_tilt.size(), positions);
  EXPECT_NEAR(record.lamina_position.back(), 0.975 * 2.85e-3, 1e-15);
  for (std::size_t position = 0; position < positions; ++position) {
    const auto first = record.outer_load.begin() + static_cast<std::ptrdiff_t>(40 * position);
    EXPECT_NEAR(std::accumulate(first, first + 40, 0.0), found.distribution.outer_load[position],
                kRoundOff * found.outer.load_max);
  }
  EXPECT_NEAR(record.bore_tilt.norm(), 1e-3, 1e-15);
  EXPECT_LT(record.moment.dot(record.bore_tilt), 0.0);
}

TEST(LaminaPoint, TiltRaisesThePressureOfStraightRollersMoreThanOfCrownedOnes) {
  const auto rise = [](PlanetaryDrivetrain drivetrain) {
    const double level = point(drivetrain).contact_pressure;
    drivetrain.misalignment = {.planet_tilt = 1e-3};
    return point(drivetrain).contact_pressure / level;
  };
  EXPECT_GT(rise(crowned(0.0)), 1.05);
  EXPECT_GT(rise(crowned(0.0)), rise(crowned(1.0)));
}

// The bearing of a sweep and that of a crown study are one: so are their lives, whatever the profile and the
// tilt. (1 % of a life is a quarter of a per cent of load; both take the same loads.)
TEST(LaminaPoint, LivesAsTheCrownStudySays) {
  for (const double rpm : {1000.0, 6000.0, 12000.0})
    for (const double drop : {0.0, 4e-6})
      for (const double tilt : {0.0, 0.5e-3, 2e-3}) {
        PlanetaryDrivetrain drivetrain = crowned(0.0);
        drivetrain.drive.speed = rpm * example::rpm;
        const crowning::CrownProblem problem =
            crowning::crown_problem(drivetrain, derive(drivetrain), {{drivetrain.drive.speed, 1.0}},
                                    crowning::LifeMethod::lundberg_palmgren);
        const bearing::profile::Profile profile =
            crowning::profile_of(crowning::family_of("iso16281", drivetrain.bearing, 1.0), {drop, 1.0});
        const double expected = crowning::life_hours(problem, profile, crowning::Lean(tilt, 0.0));
        drivetrain.bearing.rollers().profile = profile;
        drivetrain.misalignment = {.planet_tilt = tilt};
        EXPECT_NEAR(point(drivetrain).life_hours, expected, kRoundOff * expected)
            << rpm << " rpm, " << drop << " m, " << tilt << " rad";
      }
}

TEST(LaminaPoint, TiltCostsLife) {
  PlanetaryDrivetrain drivetrain = crowned(0.0);
  const double level = point(drivetrain).life_hours;
  drivetrain.misalignment = {.planet_tilt = 2e-3};
  const PointResult tilted = point(drivetrain);
  EXPECT_LT(tilted.life_hours, 0.5 * level);
  EXPECT_NEAR(tilted.life_hours,
              bearing::hours(bearing::combined_life(tilted.inner.life, tilted.outer.life),
                             bearing_duty(drivetrain, derive(drivetrain)).point.outer_speed),
              kRoundOff * level);
}

}  // namespace
}  // namespace orbearing::analysis::study_lamina_point_test
