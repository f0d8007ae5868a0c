#include "gearset/mean_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::mean_loads_test {
namespace {

constexpr double round_off =
    1e-9;  // relative; tangential force and centre distance share the root finder's error

TEST(MeanLoads, OfAStandardSetHaveNoRadialPart) {
  const PlanetarySet set = standard_set();
  const WorkingGeometry geometry = working_geometry(set);
  const MeanLoads loads = mean_loads(set, geometry, {Member::sun, 12e3, 100.0});
  // 120 N m on four planets at a pitch radius of 30 mm: 1000 N at each mesh.
  EXPECT_NEAR(loads.normal_force, 1000.0 / std::cos(set.rack.pressure_angle), 1000.0 * round_off);
  EXPECT_NEAR(loads.tangential_force, 2000.0, 2000.0 * round_off);
  EXPECT_NEAR(loads.radial_force, 0.0, 1000.0 * round_off);
}

TEST(MeanLoads, PushThePlanetOfTheReducerInward) {
  const PlanetarySet set = reducer();
  const MeanLoads loads = mean_loads(set, working_geometry(set), {Member::sun, 150e3, 600.0});
  EXPECT_LT(loads.radial_force, 0.0);
  EXPECT_GT(loads.tangential_force, 0.0);
}

TEST(MeanLoads, DrivingCarrierPushesThePlanetAgainstItsRotation) {
  const PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  const MeanLoads delivers = mean_loads(set, geometry, {Member::sun, 150e3, 116.0});
  const MeanLoads drives = mean_loads(set, geometry, {Member::carrier, 150e3, 37.0});
  EXPECT_NEAR(drives.tangential_force, -delivers.tangential_force, round_off * delivers.tangential_force);
  EXPECT_NEAR(drives.radial_force, delivers.radial_force, round_off * delivers.normal_force);
  EXPECT_GT(drives.normal_force, 0.0);
}

TEST(MeanLoads, FallWithSpeedAtConstantPower) {
  const PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  const MeanLoads slow = mean_loads(set, geometry, {Member::sun, 150e3, 300.0});
  const MeanLoads fast = mean_loads(set, geometry, {Member::sun, 150e3, 600.0});
  EXPECT_NEAR(slow.normal_force, 2.0 * fast.normal_force, round_off * slow.normal_force);
}

}  // namespace
}  // namespace orbearing::gearset::mean_loads_test
