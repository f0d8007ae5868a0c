// Issue 16, Build 2, in a point of the drivetrain: the reducer's planet on its own pin.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/study/operating_point.hpp"
#include "coupling/study/tilting_planet.hpp"
#include "tests/reducer.hpp"

namespace orbearing::study::study_tilting_planet_test {
namespace {

PlanetaryDrivetrain tilting_reducer() {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.bearing.rollers().laminae = 20;
  drivetrain.seats.tilt = TiltState::computed;
  drivetrain.cage_positions = 4;
  gearset::dynamics::SetParameters set;
  set.sun_mesh = {.pressure_angle = 0.33, .stiffness = gearset::PeriodicCurve::constant(5e8)};
  set.ring_mesh = {.pressure_angle = 0.42, .stiffness = gearset::PeriodicCurve::constant(6e8)};
  drivetrain.gear_set = [set] { return set; };
  return drivetrain;
}

TEST(TiltingPlanet, OfEqualBearingsOnAStiffPinHasTheLifeOfStatedTiltZero) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.seats.span = 0.0281;  // hardly bends
  PlanetaryDrivetrain stiff = drivetrain;
  stiff.bearing.material.youngs_modulus = 206e16;  // of the pin; dry contacts of Palmgren know no modulus
  const PointResult found = evaluate(stiff, derive(stiff));
  drivetrain.seats.tilt = TiltState::stated;
  const PointResult level = evaluate(drivetrain, derive(drivetrain));
  EXPECT_NEAR(found.life_hours / level.life_hours, 1.0, 1e-6);
  EXPECT_NEAR(found.system_life_hours / level.system_life_hours, 1.0, 1e-6);
  ASSERT_EQ(found.seats.size(), 2u);
  EXPECT_NEAR(found.seats[0].life_hours / level.life_hours, 1.0, 1e-6);
}

// The slope of the pin under equal loads is what both bearings feel, in opposite senses; it falls with the
// load.
TEST(TiltingPlanet, TiltOfTheReducerIsThatOfItsPin) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  for (const double rpm : {1000.0, 6000.0}) {
    drivetrain.drive.speed = rpm * 3.14159265358979 / 30.0;
    const DrivetrainGeometry geometry = derive(drivetrain);
    const PointResult found = evaluate(drivetrain, geometry);
    const std::vector<double> places = axial_places(drivetrain);
    const Eigen::MatrixXd bends = bearing::pin_compliance(planet_pin(drivetrain), places);
    const Eigen::Vector2d load = bearing_duty(drivetrain, geometry).point.bore_load;
    const double slope = (bends(2, 0) + bends(2, 1)) * load.norm();
    ASSERT_EQ(found.seats.size(), 2u);
    EXPECT_LT((found.seats[0].tilt + found.seats[1].tilt).norm(), 1e-6 * slope);
    EXPECT_NEAR(found.seats[0].tilt.norm() / slope, 1.0, 0.2);  // tilted rollers straighten it, their cage loads it more
  }
}

// Issue 16, Build 3. Forces of both bearings at their places, their moments and the meshes' springs hold what
// the axial forces of helical teeth put on the planet: force of the sun times the distance of both pitch
// points.
TEST(TiltingPlanet, HoldsWhatHelicalTeethOverturn) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  for (const double helix : {-0.25, 0.25}) {
    drivetrain.set.helix_angle = helix;
    const DrivetrainGeometry geometry = derive(drivetrain);
    const BearingDuty duty = bearing_duty(drivetrain, geometry);
    const double axial =
        -duty.gears.sun_torque / drivetrain.set.planets / geometry.gears.sun.pitch_radius * std::tan(helix);
    const double between =
        geometry.gears.planet.base_radius * (1.0 / std::cos(geometry.gears.sun_mesh.working_pressure_angle) +
                                             1.0 / std::cos(geometry.gears.ring_mesh.working_pressure_angle));
    const bearing::laminae::PlanetOnPinResult found = tilting_planet(drivetrain, duty);
    const std::vector<double> places = axial_places(drivetrain);
    Eigen::Vector2d held = -mesh_tilt_stiffness(drivetrain) * found.tilt;
    for (std::size_t k = 0; k < places.size(); ++k)
      held += found.bearings[k].moment - places[k] * found.bearings[k].total_bore_load;
    const double moment = axial * between;
    EXPECT_GT(std::abs(moment), 10.0);
    EXPECT_NEAR(held.x() / moment, -1.0, 1e-6);
    EXPECT_GT(found.tilt.x() * moment, 0.0);  // the planet leans the way it is pushed
    const PointResult point = evaluate(drivetrain, geometry);
    EXPECT_NEAR(point.overturning_moment / moment, 1.0, 1e-12);
    EXPECT_NEAR(point.axial_mesh_force / axial, 1.0, 1e-12);
    EXPECT_NEAR(point.sun_thrust / axial, -drivetrain.set.planets, 1e-12);
  }
}

TEST(TiltingPlanet, WithoutMeshesIsRefused) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.gear_set = nullptr;
  EXPECT_THROW(evaluate(drivetrain, derive(drivetrain)), std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::study::study_tilting_planet_test
