// Life of crowned rollers: against the lives it must equal, and its derivatives against differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/study/operating_point.hpp"
#include "tests/messages.hpp"
#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::study::crowning::crown_life_test {
namespace {

constexpr double kRoundOff = 1e-9;   // of lives, whose loads balance to 1e-12 and enter with the fourth power
constexpr double kAgreement = 1e-6;  // of a derivative and its central difference

using bearing::profile::Profile;
using bearing::profile::Straight;

TEST(CrownLife, StraightAndUntiltedIsTheLifeOfASweep) {
  PlanetaryDrivetrain drivetrain = reducer();
  for (const double rpm : {1000.0, 6000.0, 12000.0}) {
    drivetrain.drive.speed = rpm * kRpm;
    const double sweep = evaluate(drivetrain, derive(drivetrain)).life_hours;
    const double ours = life_hours(problem_at(rpm, LifeMeasure::lundberg_palmgren), Straight{}, Lean::Zero());
    EXPECT_NEAR(ours, sweep, kRoundOff * sweep) << rpm;
  }
}

TEST(CrownLife, OfTheStandardIsThatOfTheRatings) {
  const CrownProblem problem = problem_at(6000.0, LifeMeasure::iso16281);
  const Profile profile = bearing::profile::Iso16281{5.7e-3, 5.24e-3, 1.0};
  const auto loads = loads_at(problem, profile, Lean(1e-3, 0.0), 0);
  const auto set = bearing::rating::roller_set(problem.bearing);
  const auto expected = bearing::rating::lamina_reference_life(
      bearing::rating::contact_capacities(set, bearing::rating::dynamic_capacity(set)),
      loads.inner_lamina_load(), loads.outer_lamina_load(), bearing::rating::turning(bearing::Race::outer));
  const bearing::life::LogLife ours =
      log_life(problem.ratings[0], loads.inner_lamina_load(), loads.outer_lamina_load());
  EXPECT_NEAR(ours.value, std::log(expected.bearing), kRoundOff);
}

TEST(CrownLife, OfASpectrumIsMinersSum) {
  const CrownProblem both = problem_at({{1000.0 * kRpm, 0.25}, {9000.0 * kRpm, 0.75}}, LifeMeasure::iso16281);
  const double slow = life_hours(one_duty(both, 0), Straight{}, Lean(1e-3, 0.0));
  const double fast = life_hours(one_duty(both, 1), Straight{}, Lean(1e-3, 0.0));
  EXPECT_NEAR(life_hours(both, Straight{}, Lean(1e-3, 0.0)), 1.0 / (0.25 / slow + 0.75 / fast),
              kRoundOff * slow);
}

TEST(CrownLife, SharesMustAddUp) {
  EXPECT_REFUSED(std::invalid_argument, "crown_life 1",
                 problem_at({{100.0, 0.5}, {200.0, 0.4}}, LifeMeasure::iso16281));
  EXPECT_REFUSED(std::invalid_argument, "crown_life 2",
                 problem_at({{100.0, 1.5}, {200.0, -0.5}}, LifeMeasure::iso16281));
}

double log_life_at(const CrownProblem& problem, const ProfileFamily& family, const Crown& crown,
                   double tilt) {
  return std::log(life_hours(problem, profile_of(family, crown), Lean(tilt, 0.0)));
}

class CrownSlopes : public testing::TestWithParam<std::string> {};

// Of both measures, with and without film, at one point and over a spectrum.
TEST_P(CrownSlopes, AreCentralDifferences) {
  for (const LifeMeasure measure : {LifeMeasure::lundberg_palmgren, LifeMeasure::iso16281})
    for (const bool film : {false, true}) {
      CrownProblem problem = problem_at({{3000.0 * kRpm, 0.4}, {9000.0 * kRpm, 0.6}}, measure);
      if (film) problem.options.film = bearing::Lubricant{0.01, 1.5e-8};
      const ProfileFamily family = family_of(GetParam(), problem.bearing, 1500.0);
      const Crown crown{4.3e-6, has_share(family) ? 0.41 : 1.0};
      const double tilt = 0.7e-3, drop_step = 1e-11, share_step = 1e-6;
      const CrownLife ours = crown_life(problem, family, crown, Lean(tilt, 0.0));
      const auto at = [&](double drop, double share) {
        return log_life_at(problem, family, {crown.drop + drop, crown.share + share}, tilt);
      };
      EXPECT_NEAR(ours.log_hours, at(0.0, 0.0), kRoundOff);
      const double by_drop = (at(drop_step, 0.0) - at(-drop_step, 0.0)) / (2.0 * drop_step);
      EXPECT_NEAR(ours.by_drop, by_drop, kAgreement * std::abs(by_drop)) << name_of(measure) << film;
      if (!has_share(family)) continue;
      const double by_share = (at(0.0, share_step) - at(0.0, -share_step)) / (2.0 * share_step);
      EXPECT_NEAR(ours.by_share, by_share, kAgreement * std::abs(by_share)) << name_of(measure) << film;
    }
}

INSTANTIATE_TEST_SUITE_P(Families, CrownSlopes, testing::ValuesIn(family_names()), [](const auto& family) {
  std::string name = family.param;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
});

TEST(ProfileFamily, HasTheDropAskedForAtTheStation) {
  const CrownProblem problem = problem_at(6000.0, LifeMeasure::iso16281);
  for (const std::string& name : family_names()) {
    const ProfileFamily family = family_of(name, problem.bearing, 1500.0);
    for (const double drop : {0.0, 1e-6, 20e-6}) {
      const Profile made = profile_of(family, {drop, usual_share(family)});
      EXPECT_EQ(bearing::profile::kind(made), name);
      EXPECT_NEAR(bearing::profile::drop(made, 0.975 * 2.85e-3), drop, 1e-15) << name;
      EXPECT_NEAR(bearing::profile::drop(made, 0.0), 0.0, 1e-18) << name;
    }
  }
  EXPECT_REFUSED(std::invalid_argument, "crown_life 3", family_of("straight", problem.bearing, 1500.0));
}

TEST(ProfileFamily, ReferenceDropIsThatOfTheStandard) {
  // 0.00035 * 5.24 mm * ln(1/(1 - 0.975^2))
  EXPECT_NEAR(reference_drop(reducer().bearing), 0.00035 * 5.24e-3 * -std::log(1.0 - 0.975 * 0.975), 1e-15);
}

}  // namespace
}  // namespace orbearing::study::crowning::crown_life_test
