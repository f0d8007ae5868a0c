// Bearings on laminae some of whose rollers are so little loaded that one lamina or two touch: found among
// random ones, where Newton's search led to and fro and the bearing "found no static equilibrium" with 1e-13
// N remaining.
#include <gtest/gtest.h>

#include "coupling/analysis/crowning/crown_problem.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::crowning::lamina_idle_rollers_test {
namespace {

constexpr double kBalance = 1e-9;  // of the greatest load: what the search itself accepts

struct Idle {
  double rpm, power, clearance;  // [1/min], [W], [m]
  int laminae;
  const char* profile;
  double drop, tilt;  // [m], [rad]
};

class IdleRollers : public ::testing::TestWithParam<Idle> {};

TEST_P(IdleRollers, FindTheirBalance) {
  const Idle idle = GetParam();
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.drive.speed = idle.rpm * example::rpm;
  drivetrain.drive.power = idle.power;
  drivetrain.bearing.radial_clearance = idle.clearance;
  const CrownProblem problem = crown_problem(drivetrain, derive(drivetrain), {{drivetrain.drive.speed, 1.0}},
                                             LifeMethod::lundberg_palmgren, idle.laminae);
  const ProfileFamily family = family_of(idle.profile, problem.bearing, 1500.0);
  const DutyLoads found =
      loads_at(problem, profile_of(family, {idle.drop, default_share(family)}), Lean(idle.tilt, 0.0), 0);
  const bearing::QuasiStaticResult& loads = found.bearings.front();
  EXPECT_TRUE(loads.report.converged);
  // Outer loads less inner ones are the rollers' inertial loads, whatever the laminae.
  const double greatest = loads.inner_load.maxCoeff();
  const Eigen::ArrayXd inertial =
      bearing::quasi_static_bearing(problem.bearing, problem.duties[0].point, problem.options).outer_load -
      bearing::quasi_static_bearing(problem.bearing, problem.duties[0].point, problem.options).inner_load;
  EXPECT_LT((loads.outer_load - loads.inner_load - inertial).abs().maxCoeff(), kBalance * greatest);
}

INSTANTIATE_TEST_SUITE_P(Found, IdleRollers,
                         ::testing::Values(Idle{357.1489616414388, 149133.0, 0.0, 64, "circular", 15e-6,
                                                1e-3},
                                           Idle{264.09268766867933, 855312.0, 37e-6, 64, "johns-gohar",
                                                1.6453374386439429e-05, 1e-3},
                                           Idle{254.42115162761817, 820720.0, 0.0, 64, "circular",
                                                2.7952458612410566e-05, 0.5e-3}));

}  // namespace
}  // namespace orbearing::analysis::crowning::lamina_idle_rollers_test
