// Life of crowned rollers: against the lives it must equal, and its differences against known derivatives.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "coupling/analysis/operating_point.hpp"
#include "tests/messages.hpp"
#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::crown_life_test {
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
    const double ours = life_hours(problem_at(rpm, LifeMethod::lundberg_palmgren), Straight{}, Lean::Zero());
    EXPECT_NEAR(ours, sweep, kRoundOff * sweep) << rpm;
  }
}

TEST(CrownLife, OfTheStandardIsThatOfTheRatings) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const Profile profile = bearing::profile::Iso16281{5.7e-3, 5.24e-3, 1.0};
  const auto loads = loads_at(problem, profile, Lean(1e-3, 0.0), 0);
  bearing::Bearing turning = problem.bearing;
  turning.motions = bearing::rating::rotating(bearing::Race::outer);
  const bearing::BearingLife expected =
      rating_lives(bearing::rating::bearing_rating(turning), {}, {{}, loads.inner_lamina_load()},
                   {{}, loads.outer_lamina_load()})
          .reference;
  const double hours =
      bearing::hours(expected.bearing, rotating_speed(problem.bearing, problem.duties[0].point));
  EXPECT_NEAR(duty_hours(problem, loads, 0), hours, kRoundOff * hours);
}

// With an oil it is the modified life that a crown makes longest, under C as stated.
TEST(CrownLife, GoverningLifeIncludesTheOilAndTheStatedCapacity) {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.rated.oil = bearing::rating::StatedOil{.viscosity_ratio = 1.5, .contamination_factor = 0.5};
  drivetrain.rated.stated.dynamic_capacity = 20e3;
  const auto problem = [&](LifeMethod method) {
    return crown_problem(drivetrain, derive(drivetrain), {{6000.0 * kRpm, 1.0}}, method);
  };
  const CrownProblem modified = problem(LifeMethod::iso16281);
  const DutyLoads loads = loads_at(modified, Straight{}, Lean::Zero(), 0);
  const DutyHours lives = lives_at(modified, loads, 0);
  EXPECT_EQ(duty_hours(modified, loads, 0), lives.rated.modified_reference);
  EXPECT_EQ(duty_hours(problem(LifeMethod::lundberg_palmgren), loads, 0), lives.lundberg_palmgren);
  EXPECT_EQ(duty_hours(problem(LifeMethod::iso281), loads, 0), lives.lundberg_palmgren);
  drivetrain.rated.stated.dynamic_capacity = 40e3;
  constexpr double kDoubledCapacity = 16.0;  // 2^4
  EXPECT_NEAR(lives_at(problem(LifeMethod::iso16281), loads, 0).rated.reference,
              kDoubledCapacity * lives.rated.reference, kRoundOff * kDoubledCapacity * lives.rated.reference);
}

TEST(CrownLife, OfASpectrumIsMinersSum) {
  const CrownProblem both = problem_at({{1000.0 * kRpm, 0.25}, {9000.0 * kRpm, 0.75}}, LifeMethod::iso16281);
  const double slow = life_hours(one_duty(both, 0), Straight{}, Lean(1e-3, 0.0));
  const double fast = life_hours(one_duty(both, 1), Straight{}, Lean(1e-3, 0.0));
  EXPECT_NEAR(life_hours(both, Straight{}, Lean(1e-3, 0.0)), 1.0 / (0.25 / slow + 0.75 / fast),
              kRoundOff * slow);
}

TEST(CrownLife, SharesMustAddUp) {
  EXPECT_REFUSED(std::invalid_argument, "crown_life 1",
                 problem_at({{100.0, 0.5}, {200.0, 0.4}}, LifeMethod::iso16281));
  EXPECT_REFUSED(std::invalid_argument, "crown_life 2",
                 problem_at({{100.0, 1.5}, {200.0, -0.5}}, LifeMethod::iso16281));
}

// By the adjoint of the equilibrium, before differences replaced it. For both measures, without and with
// film, over a spectrum.
struct KnownSlopes {
  std::string family;
  std::array<double, 4> by_drop;     // [1/m]
  std::array<double, 4> by_share{};  // [-]
};

const std::vector<KnownSlopes>& known_slopes() {
  static const std::vector<KnownSlopes> all{
      {"chamfer", {-126152.7, -129113.5, -124118.8, -127157}, {-1.712351, -1.771612, -1.639377, -1.69862}},
      {"circular", {-235449.1, -239754.4, -229512.8, -234285.9}},
      {"straight-circular",
       {-80957.86, -83174.35, -77714.2, -79995.57},
       {-1.014356, -1.041528, -0.9220897, -0.9489088}},
      {"lundberg", {-116209.6, -119458.9, -109445.3, -112837.5}},
      {"johns-gohar", {-119834, -124239.7, -113284.5, -117836.3}},
      {"iso16281", {-116209.6, -119458.9, -109445.3, -112837.5}},
      {"fujiwara-kawase",
       {-51214.43, -52640.42, -45499.34, -47020.19},
       {-0.4369953, -0.448639, -0.3536793, -0.3647934}},
  };
  return all;
}

TEST(CrownLife, HasTheSlopesOfTheAdjoint) {
  ASSERT_EQ(known_slopes().size(), family_names().size());
  for (const KnownSlopes& known : known_slopes())
    for (std::size_t i = 0; i < 4; ++i) {
      CrownProblem problem = problem_at({{3000.0 * kRpm, 0.4}, {9000.0 * kRpm, 0.6}},
                                        i < 2 ? LifeMethod::lundberg_palmgren : LifeMethod::iso16281);
      // With the printed formula of the stress riser, as the adjoint had it.
      problem.rating = bearing::rating::bearing_rating(
          problem.bearing, {.stress_riser = bearing::rating::StressRiser::standard});
      if (i % 2 == 1) problem.options.film = bearing::Lubricant{0.01, 1.5e-8};
      const ProfileFamily family = family_of(known.family, problem.bearing, 1500.0);
      const Crown crown{4.3e-6, has_share(family) ? 0.41 : 1.0};
      const Lean lean(0.7e-3, 0.0);
      const CrownLife ours = crown_life(problem, family, crown, lean);
      EXPECT_NEAR(ours.log_hours, std::log(life_hours(problem, profile_of(family, crown), lean)), kRoundOff);
      EXPECT_NEAR(ours.by_drop, known.by_drop[i], kAgreement * std::abs(known.by_drop[i]))
          << known.family << i;
      EXPECT_NEAR(ours.by_share, known.by_share[i], kAgreement * std::abs(known.by_share[i]))
          << known.family << i;
    }
}

TEST(ProfileFamily, HasTheDropAskedForAtTheStation) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  for (const std::string& name : family_names()) {
    const ProfileFamily family = family_of(name, problem.bearing, 1500.0);
    for (const double drop : {0.0, 1e-6, 20e-6}) {
      const Profile made = profile_of(family, {drop, default_share(family)});
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

// A lean is stated along the load and across it, to its left; the tilt of the bore in x and y.
TEST(Tilted, IsStatedAlongTheLoadAndAcrossIt) {
  Duty duty;
  duty.point.bore_load = {-3e3, 4e3};
  const Eigen::Vector2d along = tilted(duty, Lean(1e-3, 0.0)).bore_tilt,
                        across = tilted(duty, Lean(0.0, 1e-3)).bore_tilt;
  EXPECT_LT((along - Eigen::Vector2d(-0.6e-3, 0.8e-3)).norm(), 1e-15);
  EXPECT_LT((across - Eigen::Vector2d(-0.8e-3, -0.6e-3)).norm(), 1e-15);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::crown_life_test
