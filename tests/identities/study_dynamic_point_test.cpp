// The dynamic operating point of the reducer against the rung below it, and what the mesh ripple does.
#include <gtest/gtest.h>

#include "coupling/study/operating_point.hpp"
#include "tests/reducer.hpp"

namespace orbearing::study {
namespace {

using testing::reducer;

// Rollers in motion carry what the quasi-static bearing carries, but for what traction takes past the bore.
constexpr double kSameLoads = 0.02;

PlanetaryDrivetrain short_run() {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  drivetrain.steady_state.observed_windows = 2;
  return drivetrain;
}

PointResult dynamic_point(const PlanetaryDrivetrain& drivetrain) {
  return evaluate(drivetrain, derive(drivetrain), Fidelity::dynamic);
}

TEST(StudyDynamicPoint, CarriesTheQuasiStaticLoads) {
  const PlanetaryDrivetrain drivetrain = short_run();
  const PointResult still = evaluate(drivetrain, derive(drivetrain));
  const PointResult moving = dynamic_point(drivetrain);
  ASSERT_TRUE(moving.dynamic.has_value());
  EXPECT_TRUE(moving.dynamic->steady);
  EXPECT_NEAR(moving.inner.load_rms / still.inner.load_rms, 1.0, kSameLoads);
  EXPECT_NEAR(moving.outer.load_rms / still.outer.load_rms, 1.0, kSameLoads);
  EXPECT_EQ(moving.planet_load, still.planet_load);
  EXPECT_GT(moving.dynamic->loss.total(), 0.0);
}

// A ripple of a fifth of the load at mesh frequency, below the bearing's resonances, shows in the largest
// roller load at least as a fifth of it would, and hardly in the life-giving mean.
TEST(StudyDynamicPoint, MeshRippleRaisesTheLargestLoad) {
  PlanetaryDrivetrain drivetrain = short_run();
  const PointResult calm = dynamic_point(drivetrain);
  drivetrain.dynamics.ripple.amplitude = 0.2 * calm.tangential_load;
  const PointResult rippled = dynamic_point(drivetrain);
  EXPECT_GT(rippled.inner.load_max, 1.1 * calm.inner.load_max);
  EXPECT_LT(rippled.life_hours, calm.life_hours);
}

}  // namespace
}  // namespace orbearing::study
