// Life from half-space pressures: effects that it must have, and that few cage angles are enough.
#include "coupling/analysis/crowning/crown_grid.hpp"
#include "coupling/analysis/crowning/half_space_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/crowning/planet_bearing.hpp"

namespace orbearing::analysis::crowning::pressure_life_test {
namespace {

constexpr double kFewAngles = 1e-3;  // of lives: power means over 30 places or 60

TEST(PressureLife, TwoCageAnglesAreEnough) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const RollerPressure pressure(problem);
  for (const double tilt : {0.0, 2e-3}) {
    const double four =
        pressure_life_hours(problem, pressure, bearing::profile::Straight{}, Lean(tilt, 0.0), 4);
    EXPECT_NEAR(pressure_life_hours(problem, pressure, bearing::profile::Straight{}, Lean(tilt, 0.0), 2),
                four, kFewAngles * four);
  }
}

// Away from sharp ends the laminae carry the pressures of the half-space: a profile whose pressure decreases
// towards the ends has the life of its laminae without the stress riser, within the error of springs side by
// side.
TEST(PressureLife, OfADeepProfileIsThatOfItsLaminaeWithoutRiser) {
  constexpr double kPressure = 0.05;  // of pressure, with whose ninth power the life goes
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const RollerPressure pressure(problem);
  const bearing::profile::Profile deep = bearing::profile::CircularCrown{5.7e-3, 12e-6};
  const auto loads = loads_at(problem, deep, Lean::Zero(), 0);
  const auto set = bearing::rating::roller_set(problem.bearing);
  const auto rating = bearing::life::lamina_rating(
      bearing::rating::contact_capacities(set, bearing::rating::dynamic_capacity(set)),
      problem.bearing.rollers().laminae, problem.bearing.motions);
  const double revolutions =
      bearing::life::lamina_life(rating, loads.inner_lamina_load(), loads.outer_lamina_load()).bearing;
  const double expected =
      bearing::hours(revolutions, rotating_speed(problem.bearing, problem.duties[0].point));
  const double ours = pressure_life_hours(problem, pressure, deep, Lean::Zero());
  EXPECT_NEAR(std::pow(ours / expected, -1.0 / 9.0), 1.0, kPressure);
}

// The damage at a sharp end is that of a pressure averaged over one half-width, whatever the number of
// laminae. The share of straight rollers is taken over a small crown near the best one, whose life hardly
// depends on its drop.
TEST(PressureLife, OfStraightRollersConvergesWithFinerLaminae) {
  constexpr double kConverged = 0.005;
  struct Speed {
    double rpm, drop;  // [m]
  };
  for (const Speed& at : {Speed{1000.0, 0.7e-6}, Speed{6000.0, 0.15e-6}, Speed{12000.0, 0.3e-6}}) {
    const auto share = [&](int laminae) {
      CrownProblem problem = crown_problem(reducer(), derive(reducer()), {{at.rpm * kRpm, 1.0}},
                                           LifeMethod::lundberg_palmgren, laminae);
      const RollerPressure pressure(problem);
      const ProfileFamily family = family_of("iso16281", problem.bearing, 1.0);
      return pressure_life_hours(problem, pressure, bearing::profile::Straight{}, Lean::Zero()) /
             pressure_life_hours(problem, pressure, profile_of(family, {at.drop, 1.0}), Lean::Zero());
    };
    const double coarse = share(40), fine = share(200);
    EXPECT_NEAR(fine, coarse, kConverged) << at.rpm;
    EXPECT_LT(fine, 1.0);
    EXPECT_GE(fine, kKeptLife);  // no crown is needed, with 40 laminae and with 200
    EXPECT_GE(coarse, kKeptLife);
  }
}

TEST(PressureLife, CrownSavesLifeUnderTiltAndCostsItWithout) {
  const CrownProblem problem = problem_at(6000.0, LifeMethod::iso16281);
  const RollerPressure pressure(problem);
  const bearing::profile::Profile crowned = bearing::profile::Iso16281{5.7e-3, 5.24e-3, 1.0};
  const auto straight = pressure_lives(problem, pressure, bearing::profile::Straight{}, {0.0, 2e-3}, 2);
  const auto with_crown = pressure_lives(problem, pressure, crowned, {0.0, 2e-3}, 2);
  EXPECT_LT(with_crown[0], straight[0]);
  EXPECT_GT(with_crown[1], 1.5 * straight[1]);
}

}  // namespace
}  // namespace orbearing::analysis::crowning::pressure_life_test
