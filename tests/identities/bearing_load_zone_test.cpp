// Properties of every load zone, whatever the bearing, the clearance, the film and the motion of the carrier.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::bearing_load_zone_test {
namespace {

using constants::two_pi;

// Tolerance over the largest load: the solver stops at 1e-9 of the force scale, and a single roller may have
// a few times that error.
constexpr double kSolved = 1e-8;

struct Case {
  std::string name;
  Bearing bearing;
  OperatingPoint point;
  QuasiStaticOptions options;
};

std::vector<Case> cases() {
  OperatingPoint planet = example_bearings::planet_motion(example_bearings::rpm(6000.0));
  planet.bore_load = {500.0, 1060.0};
  OperatingPoint speeding_up = planet;
  speeding_up.carrier.acceleration = 2e4;
  Bearing loose = example_bearings::planet_bearing(), tight = example_bearings::planet_bearing();
  loose.radial_clearance = 37e-6;
  tight.radial_clearance = -10e-6;
  QuasiStaticOptions oiled;
  oiled.film = Lubricant{.viscosity = 0.01, .pressure_viscosity = 1.5e-8};
  return {{"bearing 209 at rest",
           example_bearings::bearing_209(),
           example_bearings::static_load(4450.0, 0.4),
           {}},
          {"planet, no clearance", example_bearings::planet_bearing(), planet, {}},
          {"planet, clearance", loose, planet, {}},
          {"planet, interference", tight, planet, {}},
          {"planet, carrier speeding up", loose, speeding_up, {}},
          {"planet, film", example_bearings::planet_bearing(), planet, oiled},
          {"planet, film and clearance", loose, planet, oiled}};
}

Eigen::Vector2d sum_of(const Eigen::ArrayXd& loads, const Eigen::ArrayXd& angle) {
  return {(loads * angle.cos()).sum(), (loads * angle.sin()).sum()};
}

QuasiStaticState state_of(const Case& c, double first_roller) {
  return quasi_static_state(c.bearing, c.point, c.options, first_roller);
}

TEST(LoadZone, OuterLoadsSumToTheLoadOnTheBore) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Eigen::Vector2d through_cage =
        load_through_cage(c.bearing, geometry_of(c.bearing), c.point.carrier, c.options.inertia);
    for (double first = 0.0; first < 0.45; first += 0.05) {
      const QuasiStaticState state = state_of(c, first);
      ASSERT_TRUE(state.report.converged) << state.report.message;
      const Eigen::Vector2d rest = c.point.bore_load + through_cage + sum_of(state.outer_load, state.angle);
      EXPECT_LT(rest.norm(), kSolved * state.outer_load.maxCoeff());
    }
  }
}

// The pin holds the load on the bore and all that the carrier swings round: the cage and every roller, at
// r_c.
TEST(LoadZone, PinCarriesTheLoadAndAllOrbitingMasses) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const BearingGeometry geometry = geometry_of(c.bearing);
    const CarrierMotion& carrier = c.point.carrier;
    const double mass = geometry.cage_mass + c.bearing.rollers().count * geometry.element_mass;
    const Eigen::Vector2d orbiting(mass * carrier.speed * carrier.speed * carrier.orbit_radius,
                                   -mass * carrier.acceleration * carrier.orbit_radius);
    const QuasiStaticState state = state_of(c, 0.1);
    // Equally spaced rollers on one circle: their own orbits cancel, and half of r_c's part comes through
    // each path.
    const Eigen::Vector2d on_pin = -sum_of(state.inner_load, state.angle);
    EXPECT_LT((on_pin - c.point.bore_load - orbiting).norm(), kSolved * state.outer_load.maxCoeff());
  }
}

TEST(LoadZone, CyclicPermutationOfTheRollersChangesNothing) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const QuasiStaticState state = state_of(c, 0.07);
    const QuasiStaticState shifted = state_of(c, 0.07 + two_pi / c.bearing.rollers().count);
    const double tolerance = kSolved * state.outer_load.maxCoeff();
    for (Eigen::Index j = 0; j + 1 < c.bearing.rollers().count; ++j) {
      EXPECT_NEAR(shifted.outer_load[j], state.outer_load[j + 1], tolerance);
      EXPECT_NEAR(shifted.inner_load[j], state.inner_load[j + 1], tolerance);
    }
    EXPECT_NEAR(shifted.outer_load[c.bearing.rollers().count - 1], state.outer_load[0], tolerance);
  }
}

// A load along x on rollers placed symmetrically about x; the carrier's motion keeps that symmetry.
TEST(LoadZone, IsSymmetricAboutALoadAlongTheCarrierArm) {
  for (Case c : cases()) {
    if (c.point.carrier.acceleration != 0.0) continue;
    SCOPED_TRACE(c.name);
    c.point.bore_load = {1500.0, 0.0};
    const QuasiStaticState state = state_of(c, 0.0);
    const Eigen::Index rollers = c.bearing.rollers().count;
    for (Eigen::Index j = 1; j < rollers; ++j) {
      EXPECT_NEAR(state.outer_load[j], state.outer_load[rollers - j], kSolved * state.outer_load.maxCoeff());
    }
  }
}

// Without clearance, film and inertia nothing but the line contacts sets a scale: Q = K delta^(10/9) is
// homogeneous.
TEST(LoadZone, DoubledLoadDoublesEveryRollerAtZeroClearance) {
  const Bearing bearing = example_bearings::bearing_209();
  const QuasiStaticState once =
      quasi_static_state(bearing, example_bearings::static_load(3000.0, 0.3), {}, 0.1);
  const QuasiStaticState twice =
      quasi_static_state(bearing, example_bearings::static_load(6000.0, 0.3), {}, 0.1);
  const double tolerance = kSolved * twice.outer_load.maxCoeff();
  for (Eigen::Index j = 0; j < 14; ++j) EXPECT_NEAR(twice.outer_load[j], 2.0 * once.outer_load[j], tolerance);
  const Eigen::Vector2d expected = std::pow(2.0, 0.9) * once.displacement;
  EXPECT_LT((twice.displacement - expected).norm(), kSolved * expected.norm());
}

// With clearance the same holds when clearance grows with the elastic approach: load x 2, clearance x 2^0.9.
TEST(LoadZone, ScalesWithTheClearanceGrownInStep) {
  Bearing small = example_bearings::bearing_209(), large = small;
  small.radial_clearance = 30e-6;
  large.radial_clearance = std::pow(2.0, 0.9) * 30e-6;
  const QuasiStaticState once =
      quasi_static_state(small, example_bearings::static_load(3000.0, 0.3), {}, 0.1);
  const QuasiStaticState twice =
      quasi_static_state(large, example_bearings::static_load(6000.0, 0.3), {}, 0.1);
  const double tolerance = kSolved * twice.outer_load.maxCoeff();
  for (Eigen::Index j = 0; j < 14; ++j) EXPECT_NEAR(twice.outer_load[j], 2.0 * once.outer_load[j], tolerance);
}

// Clearance takes rollers out of the load zone, so the largest load only grows with it.
TEST(LoadZone, LargestLoadGrowsWithClearance) {
  Bearing bearing = example_bearings::bearing_209();
  double largest = 0.0;
  for (double clearance = 0.0; clearance < 200e-6; clearance += 20e-6) {
    bearing.radial_clearance = clearance;
    const double load =
        quasi_static_state(bearing, example_bearings::static_load(-4450.0), {}, 0.0).outer_load.maxCoeff();
    EXPECT_GT(load, largest);
    largest = load;
  }
}

}  // namespace
}  // namespace orbearing::bearing::bearing_load_zone_test
