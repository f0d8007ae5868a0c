// Lives on laminae in motion against the quasi-static life of the same bearing: one way, and as one system.
#include <gtest/gtest.h>

#include "coupling/analysis/crowning/crown_problem.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/rated_bearing.hpp"
#include "tests/coupled_reducer.hpp"

namespace orbearing::analysis::study_lamina_motion_test {
namespace {

// Lives of rollers in motion, without the vibration of the meshes, are within this of quasi-static ones: a
// load within one and a quarter per cent.
constexpr double kMotion = 0.05;

PlanetaryDrivetrain aligned_gears() {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  const gearset::dynamics::SetParameters gears = example::reducer_gears(drivetrain);
  drivetrain.gear_set = [gears] { return gears; };
  drivetrain.mesh_variation = false;
  drivetrain.drive.speed = 9000.0 * example::rpm;
  drivetrain.bearing.rollers().laminae = 10;
  drivetrain.steady_state.observed_windows = 2;
  return drivetrain;
}

PlanetaryDrivetrain crowned(double drop, double tilt) {
  PlanetaryDrivetrain drivetrain = aligned_gears();
  drivetrain.bearing.rollers().profile =
      crowning::profile_of(crowning::family_of("iso16281", drivetrain.bearing, 1.0), {drop, 1.0});
  drivetrain.misalignment.planet_tilt = tilt;
  return drivetrain;
}

PointResult point(const PlanetaryDrivetrain& drivetrain, Fidelity fidelity = Fidelity::quasi_static) {
  return evaluate(drivetrain, derive(drivetrain), fidelity);
}

TEST(LaminaMotion, LivesOneWayAsAtRest) {
  for (const double drop : {0.0, 4e-6})
    for (const double tilt : {0.0, 2e-3}) {
      const PlanetaryDrivetrain drivetrain = crowned(drop, tilt);
      const PointResult still = point(drivetrain), moving = point(drivetrain, Fidelity::dynamic);
      EXPECT_NEAR(moving.life_hours / still.life_hours, 1.0, kMotion) << drop << ' ' << tilt;
      EXPECT_NEAR(moving.contact_pressure / still.contact_pressure, 1.0, kMotion) << drop << ' ' << tilt;
    }
}

// Rollers that are not cut have a profile all the same: the largest load is distributed along it.
TEST(LaminaMotion, PressureOfWholeRollersAsAtRest) {
  PlanetaryDrivetrain drivetrain = crowned(4e-6, 0.0);
  drivetrain.bearing.rollers().laminae = 0;
  const PointResult still = point(drivetrain), moving = point(drivetrain, Fidelity::dynamic);
  EXPECT_NEAR(moving.contact_pressure / still.contact_pressure, 1.0, kMotion);
  const double even =
      largest_hertz_pressure(drivetrain, derive(drivetrain), moving.inner.load_max, moving.outer.load_max);
  EXPECT_GT(moving.contact_pressure, 1.1 * even);  // or the profile had no visible effect
}

TEST(LaminaMotion, LivesInOneSystemAsAtRest) {
  PlanetaryDrivetrain drivetrain = crowned(4e-6, 2e-3);
  drivetrain.steady_state.most_windows = 2;
  drivetrain.steady_state.observed_windows = 1;
  const PointResult still = point(drivetrain), moving = point(drivetrain, Fidelity::monolithic);
  EXPECT_NEAR(moving.life_hours / still.life_hours, 1.0, kMotion);
  drivetrain.misalignment = {};
  EXPECT_GT(point(drivetrain).life_hours, 1.2 * still.life_hours);  // or the tilt had no visible effect
}

}  // namespace
}  // namespace orbearing::analysis::study_lamina_motion_test
