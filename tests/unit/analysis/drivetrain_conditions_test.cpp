#include "coupling/analysis/drivetrain_conditions.hpp"

#include <gtest/gtest.h>

#include "tests/reducer.hpp"

namespace orbearing::analysis::drivetrain_conditions_test {
namespace {

StatedSet reducer_set() {
  const analysis::PlanetaryDrivetrain reducer = example::reducer();
  return {.teeth = reducer.set, .planets = reducer};
}

using Condition = bool (*)(const StatedSet&);
using Change = void (*)(StatedSet&);

bool holds_with(Condition condition, Change change) {
  StatedSet set = reducer_set();
  change(set);
  return condition(set);
}

TEST(DrivetrainConditions, PlanetsTiltWhereTheirEndsDiffer) {
  EXPECT_FALSE(planets_tilt(reducer_set()));
  for (const Change change : std::initializer_list<Change>{
           [](StatedSet& m) { m.teeth.helix_angle = -0.1; }, [](StatedSet& m) { m.teeth.stepped.teeth = 18; },
           [](StatedSet& m) { m.planets.seats.ends = bearing::PinEnds::one; },
           [](StatedSet& m) { m.planets.seats.ends = bearing::PinEnds::flexpin; },
           [](StatedSet& m) { m.planets.seats.radial_inclination = 1e-4; },
           [](StatedSet& m) { m.planets.seats.tangential_inclination = -1e-4; },
           [](StatedSet& m) { m.planets.seats.carrier_twist = 1e6; },
           [](StatedSet& m) {
             m.planets.seats.axial_positions = {-7e-3, 6e-3};
           },
           [](StatedSet& m) {
             m.planets.seats.clearance_differences = {0.0, 5e-6};
           },
           [](StatedSet& m) {
             m.planets.bearing.rollers().profile =
                 bearing::profile::Table{{-2.85e-3, 0.0, 2.85e-3}, {4e-6, 0.0, 5e-6}};
           },
           [](StatedSet& m) {
             m.profile = {.kind = bearing::profile::Kind::table,
                          .x = {-2.85e-3, 0.0, 2.85e-3},
                          .drops = {4e-6, 0.0, 5e-6}};
           }})
    EXPECT_TRUE(holds_with(planets_tilt, change));
}

// Values are compared in the order of the places, not as listed.
TEST(DrivetrainConditions, MirroredEndsDoNotTiltAPlanet) {
  EXPECT_FALSE(holds_with(planets_tilt, [](StatedSet& m) {
    m.planets.seats.axial_positions = {7e-3, -7e-3, 0.0};
    m.planets.seats.clearance_differences = {5e-6, 5e-6, 1e-6};
  }));
  EXPECT_TRUE(holds_with(planets_tilt, [](StatedSet& m) {
    m.planets.seats.axial_positions = {7e-3, 0.0, -7e-3};
    m.planets.seats.clearance_differences = {5e-6, 1e-6, 6e-6};
  }));
}

TEST(DrivetrainConditions, BearingsSideBySideTiltWithTheirPin) {
  EXPECT_TRUE(bearings_tilt(reducer_set()));  // two
  EXPECT_FALSE(holds_with(bearings_tilt, [](StatedSet& m) { m.planets.bearings_per_planet = 1; }));
  EXPECT_FALSE(pin_links_rows(reducer_set()));
  EXPECT_TRUE(holds_with(pin_links_rows, [](StatedSet& m) { m.planets.bearings_per_planet = 3; }));
}

TEST(DrivetrainConditions, PlanetsCountWithoutMassWhereTheyBendTiltOrArePressedOn) {
  EXPECT_FALSE(planet_counts_without_mass(reducer_set()));
  for (const Change change : std::initializer_list<Change>{
           [](StatedSet& m) { m.planets.rim = analysis::PlanetRim::elastic; },
           [](StatedSet& m) { m.planets.mounting.state = bearing::ClearanceState::unmounted; },
           [](StatedSet& m) {
             m.planets.seats.tilt = analysis::TiltState::computed;
             m.teeth.helix_angle = 0.1;
           }})
    EXPECT_TRUE(holds_with(planet_counts_without_mass, change));
  EXPECT_FALSE(holds_with(planet_counts_without_mass,
                          [](StatedSet& m) { m.planets.seats.tilt = analysis::TiltState::computed; }));
}

TEST(DrivetrainConditions, SpringsFollowFromBearingsUnlessTheyAreStated) {
  EXPECT_TRUE(bearings_make_springs(reducer_set()));
  EXPECT_FALSE(
      holds_with(bearings_make_springs, [](StatedSet& m) { m.gears.choice.bearing_stiffness = 1e8; }));
  EXPECT_TRUE(holds_with(bearings_make_springs, [](StatedSet& m) {
    m.gears.choice.bearing_stiffness = 1e8;
    m.planets.rim = analysis::PlanetRim::elastic;
  }));
  EXPECT_FALSE(
      holds_with(bearings_make_springs, [](StatedSet& m) { m.planets.bearing.rollers().count = 0; }));
  EXPECT_TRUE(holds_with(loads_make_springs, [](StatedSet& m) {
    m.gears.choice.bearing_stiffness = 1e8;
    m.teeth.flanks.contact = gearset::ToothContact::loaded;
  }));
}

TEST(DrivetrainConditions, MeshesFollowFromTeethUnlessBothAreStated) {
  EXPECT_TRUE(teeth_make_meshes(reducer_set()));
  EXPECT_TRUE(holds_with(teeth_make_meshes, [](StatedSet& m) { m.gears.choice.sun_mesh_stiffness = 1e8; }));
  EXPECT_FALSE(holds_with(teeth_make_meshes, [](StatedSet& m) {
    m.gears.choice.sun_mesh_stiffness = m.gears.choice.ring_mesh_stiffness = 1e8;
  }));
  EXPECT_FALSE(holds_with(teeth_make_meshes, [](StatedSet& m) { m.teeth.sun_teeth = 0; }));
}

TEST(DrivetrainConditions, FitsAreWarmBeyondTheTemperatureOfTheSizes) {
  EXPECT_FALSE(fits_are_warm(reducer_set()));
  EXPECT_FALSE(holds_with(fits_are_warm, [](StatedSet& m) { m.planets.mounting.planet_temperature = 20.0; }));
  EXPECT_TRUE(holds_with(fits_are_warm, [](StatedSet& m) { m.planets.mounting.planet_temperature = 70.0; }));
}

TEST(DrivetrainConditions, SpeedsChangeInARunUp) {
  EXPECT_TRUE(speed_is_steady(reducer_set()));
  EXPECT_FALSE(holds_with(speed_is_steady, [](StatedSet& m) { m.planets.run_up.acceleration = 10.0; }));
  EXPECT_FALSE(holds_with(gears_run_up, [](StatedSet& m) { m.gears.choice.run_up.duration = 0.1; }));
  EXPECT_TRUE(
      holds_with(gears_run_up, [](StatedSet& m) { m.gears.choice.run_up = {.from = 0.5, .duration = 0.1}; }));
}

TEST(DrivetrainConditions, AreOfOneSetOrOfAllOnTheirShafts) {
  using gearset::Member;
  StatedDrivetrain single{.sets = {{"", reducer_set()}}};
  EXPECT_TRUE(carrier_rotates(single, ""));
  EXPECT_TRUE(resonances_are_named(single));
  EXPECT_FALSE(is_one_system(single));
  single.sets[0].set.complement = Complement::full;
  EXPECT_TRUE(is_one_system(single));
  single.sets[0].set.planets.mesh_variation = false;
  EXPECT_FALSE(resonances_are_named(single));
  single.sets[0].set.teeth.fixed_member = Member::carrier;
  EXPECT_FALSE(carrier_rotates(single, ""));
  const StatedDrivetrain two{
      .sets = {{"first", reducer_set()}, {"second", reducer_set()}},
      .shafts = {{.name = "housing", .members = {{0, Member::ring}, {1, Member::carrier}}, .ground = true}}};
  EXPECT_TRUE(carrier_rotates(two, "first"));
  EXPECT_FALSE(carrier_rotates(two, "second"));
  EXPECT_TRUE(carrier_rotates(two, ""));
  EXPECT_FALSE(resonances_are_named(two));
}

}  // namespace
}  // namespace orbearing::analysis::drivetrain_conditions_test
