// Crowning with a computed tilt of the planet on its pin.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/analysis/crowning/crown_grid.hpp"
#include "coupling/analysis/crowning/half_space_search.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "tests/messages.hpp"
#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::study_crown_planet_test {
namespace {

// The search for an equilibrium ends at 1e-12 of the load; other instruction sets add up in another order.
constexpr double kBalance = 1e-8;

PlanetaryDrivetrain tilting() {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.bearing.rollers().laminae = 40;
  drivetrain.seats.tilt = TiltState::computed;
  gearset::dynamics::SetParameters set;
  set.sun_mesh = {.pressure_angle = 0.33, .stiffness = gearset::PeriodicCurve::constant(5e8)};
  set.ring_mesh = {.pressure_angle = 0.42, .stiffness = gearset::PeriodicCurve::constant(6e8)};
  drivetrain.gear_set = [set] { return set; };
  return drivetrain;
}

CrownProblem problem_of(const PlanetaryDrivetrain& drivetrain) {
  return crown_problem(drivetrain, derive(drivetrain), {{drivetrain.drive.speed, 1.0, {}}},
                       LifeMethod::lundberg_palmgren);
}

const bearing::profile::Profile kStraight = bearing::profile::Straight{};

// Unlike bearings on a pin that leans: the mean of their damage is one life in sweeps and crown studies.
TEST(CrownOfAPlanet, StraightItHasTheLifeOfASweep) {
  PlanetaryDrivetrain drivetrain = tilting();
  drivetrain.seats.clearance_differences = {0.0, 5e-6};
  drivetrain.seats.tangential_inclination = 0.2e-3;
  const PointResult swept = evaluate(drivetrain, derive(drivetrain));
  const CrownProblem problem = problem_of(drivetrain);
  EXPECT_NEAR(life_hours(problem, kStraight, Lean::Zero()) / swept.life_hours, 1.0, kBalance);
  const DutyLoads loads = loads_at(problem, kStraight, Lean::Zero(), 0);
  ASSERT_EQ(loads.bearings.size(), 2u);
  EXPECT_NEAR(loads.tilt, std::max(swept.seats[0].tilt.norm(), swept.seats[1].tilt.norm()),
              1e-6 * loads.tilt);
  EXPECT_GT(loads.load_share, 1.1);
  drivetrain.seats.tangential_inclination = 0.0;
  EXPECT_GT(loads_at(problem_of(drivetrain), kStraight, Lean::Zero(), 0).load_share,
            1.05);  // by clearance alone
}

// An inclination that a study adds has the same effect as one that a case states.
TEST(CrownOfAPlanet, LeansAsItsPinIsInclined) {
  PlanetaryDrivetrain inclined = tilting();
  inclined.seats.radial_inclination = 0.1e-3;
  inclined.seats.tangential_inclination = 0.3e-3;
  const double stated = life_hours(problem_of(inclined), kStraight, Lean::Zero());
  EXPECT_NEAR(life_hours(problem_of(tilting()), kStraight, Lean(0.1e-3, 0.3e-3)) / stated, 1.0, kBalance);
  EXPECT_LT(stated, 0.9 * life_hours(problem_of(tilting()), kStraight, Lean::Zero()));
}

// Equal bearings on a pin that does not bend, in meshes without tilt stiffness: one bearing that does not
// tilt.
TEST(CrownOfAPlanet, OnAStiffPinIsOneBearingThatStandsLevel) {
  PlanetaryDrivetrain drivetrain = tilting();
  drivetrain.bearing.material.youngs_modulus = 206e16;  // Palmgren's dry contacts have none
  drivetrain.seats.span = 0.0281;
  const CrownProblem planet = problem_of(drivetrain);
  drivetrain.seats.tilt = TiltState::stated;
  const CrownProblem one = problem_of(drivetrain);
  const bearing::profile::Profile crowned = bearing::profile::Iso16281{5.7e-3, 5.24e-3, 0.5};
  EXPECT_NEAR(life_hours(planet, crowned, Lean::Zero()) / life_hours(one, crowned, Lean::Zero()), 1.0, 1e-6);
}

TEST(CrownOfAPlanet, HasOneMember) {
  const CrownProblem problem = problem_of(tilting());
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1.0);
  EXPECT_REFUSED(std::invalid_argument, "crown members",
                 (void)best_crown(problem, family, members_of({0.0, 1e-3}, {}), {.greatest_drop = 1e-5}));
}

TEST(CrownOfAPlanet, OnAnInclinedPinWantsACrownThatNoDropOfAGridBeats) {
  PlanetaryDrivetrain drivetrain = tilting();
  drivetrain.seats.tangential_inclination = 3e-3;
  const CrownProblem problem = problem_of(drivetrain);
  for (const std::string kind : {"iso16281", "straight-circular"}) {
    const ProfileFamily family = family_of(kind, problem.bearing, 1500.0);
    const CrownOptimum best =
        best_crown(problem, family, members_of({0.0}, {}), {.greatest_drop = 16e-6, .starts = 3, .jobs = 2});
    EXPECT_GT(best.crown.drop, 0.5e-6) << kind;
    for (int i = 0; i <= 16; ++i)
      EXPECT_GE(best.life_hours * (1.0 + 1e-9),
                life_hours(problem, profile_of(family, {i * 1e-6, default_share(family)}), Lean::Zero()))
          << kind << i;
  }
}

// A tolerance of the pin costs life, its worst corner more; twice as many nodes hardly change that.
TEST(CrownOfAPlanet, LivesShorterWhereItsPinMayMiss) {
  const CrownProblem problem = problem_of(tilting());
  const RollerPressure pressure(problem);
  const ProfileFamily family = family_of("iso16281", problem.bearing, 1.0);
  const auto advice = [&](Distribution distribution, double tilt) {
    return half_space_advice(
        problem, pressure, family, 1.0,
        {.tolerance = {0.0, tilt}, .distribution = distribution, .greatest_drop = 4e-6, .jobs = 2});
  };
  const double exact = advice(Distribution::normal, 0.0).life_hours;
  const HalfSpaceAdvice normal = advice(Distribution::normal, 0.6e-3);
  EXPECT_LT(normal.life_hours, 0.9 * exact);
  EXPECT_LT(advice(Distribution::worst, 0.6e-3).life_hours, 0.9 * normal.life_hours);
  EXPECT_GT(normal.quadrature_error, 0.0);
  EXPECT_LT(normal.quadrature_error, 0.02);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::study_crown_planet_test
