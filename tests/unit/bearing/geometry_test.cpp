#include "bearing/geometry.hpp"

#include <gtest/gtest.h>

#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::geometry_test {
namespace {

using constants::pi;

constexpr double kRoundOff = 1e-14;      // products and sums in double precision, relative
constexpr double kHundredthGram = 1e-5;  // [kg] the hand values below are given to this

TEST(Geometry, RacesOfThePrintedDiameters) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  EXPECT_NEAR(2.0 * geometry.inner_radius, 30.40e-3, kRoundOff);
  EXPECT_NEAR(2.0 * geometry.outer_radius, 40.88e-3, kRoundOff);
}

TEST(Geometry, ClearanceIsDiametralAndSharedByBothRaces) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.radial_clearance = 40e-6;
  const BearingGeometry geometry = geometry_of(bearing);
  EXPECT_NEAR(2.0 * (geometry.outer_radius - geometry.inner_radius - bearing.rollers().diameter), 40e-6,
              kRoundOff);
  EXPECT_NEAR(0.5 * (geometry.outer_radius + geometry.inner_radius), geometry.pitch_radius, kRoundOff);
}

TEST(Geometry, RollerMassAndInertiaByHand) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  EXPECT_NEAR(geometry.element_mass, 0.96e-3, kHundredthGram);
  EXPECT_NEAR(geometry.element_inertia, 0.5 * geometry.element_mass * 2.62e-3 * 2.62e-3, 1e-9 * kRoundOff);
}

TEST(Geometry, CageIsARingLessItsPockets) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  const double ring = 0.25 * pi * (38.54e-3 * 38.54e-3 - 33.44e-3 * 33.44e-3) * 9e-3;
  const double pockets = 15.0 * 2.55e-3 * 5.7e-3 * 5.24e-3;
  EXPECT_NEAR(geometry.cage_mass, 1310.0 * (ring - pockets), kRoundOff);
  const double inertia = geometry.cage_mass * (33.44e-3 * 33.44e-3 + 38.54e-3 * 38.54e-3) / 8.0;
  EXPECT_NEAR(geometry.cage_inertia, inertia, inertia * kRoundOff);
}

TEST(Geometry, NoCageWithoutWidth) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.cage = {};
  EXPECT_EQ(geometry_of(bearing).cage_mass, 0.0);
  EXPECT_EQ(geometry_of(bearing).cage_inertia, 0.0);
}

TEST(Geometry, RingMassesByHand) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  EXPECT_NEAR(geometry.outer_ring_mass, 7850.0 * 0.25 * pi * (2209.0 - 1671.1744) * 1e-6 * 11.9e-3,
              kRoundOff);
  EXPECT_NEAR(geometry.inner_ring_mass, 7850.0 * 0.25 * pi * (924.16 - 625.0) * 1e-6 * 11.9e-3, kRoundOff);
}

// Rollers on the pin itself: what is left between bore and race is round-off, and would be a body without mass.
TEST(Geometry, WithoutAnInnerRingThePinBeneathTheRaceMoves) {
  Bearing bearing = example_bearings::planet_bearing();
  const double race = 2.0 * geometry_of(bearing).inner_radius;
  const double pin = bearing.material.density * 0.25 * pi * race * race * bearing.width;
  for (const double round_off : {-1e-9, 0.0, 1e-9}) {
    bearing.inner.seat_diameter = race * (1.0 + round_off);
    EXPECT_NEAR(geometry_of(bearing).inner_ring_mass, pin, 1e-12 * pin);
  }
  bearing.inner.seat_diameter = 1.01 * race;
  EXPECT_LT(geometry_of(bearing).inner_ring_mass, 0.0);  // refused
}

TEST(Geometry, EquivalentRadiusIsConvexInsideAndConcaveOutside) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  EXPECT_NEAR(1.0 / equivalent_radius(geometry, Race::inner), 1.0 / 2.62e-3 + 1.0 / 15.20e-3, 1e-9);
  EXPECT_NEAR(1.0 / equivalent_radius(geometry, Race::outer), 1.0 / 2.62e-3 - 1.0 / 20.44e-3, 1e-9);
}

// Pure rolling: at both races the roller's surface has the race's speed.
TEST(Kinematics, RollerSurfaceKeepsUpWithBothRaces) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  for (const double inner : {0.0, 100.0, -300.0}) {
    for (const double outer : {0.0, 500.0, -720.0}) {
      const double cage = kinematic_cage_speed(geometry, inner, outer);
      const double spin = kinematic_roller_spin(geometry, inner, outer);
      const double centre = cage * geometry.pitch_radius;
      EXPECT_NEAR(centre + spin * geometry.element_radius, outer * geometry.outer_radius, 1e-12);
      EXPECT_NEAR(centre - spin * geometry.element_radius, inner * geometry.inner_radius, 1e-12);
    }
  }
}

TEST(Kinematics, CageFollowsATurningBoreWithThePlusSign) {
  const BearingGeometry geometry = geometry_of(example_bearings::planet_bearing());
  EXPECT_NEAR(kinematic_cage_speed(geometry, 0.0, -720.0), -360.0 * (1.0 + 5.24 / 35.64), 1e-10);
}

}  // namespace
}  // namespace orbearing::bearing::geometry_test
