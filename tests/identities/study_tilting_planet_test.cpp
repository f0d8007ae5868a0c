// Computed tilt in a point of the drivetrain: the reducer's planet on its own pin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/rated_bearing.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "tests/coupled_reducer.hpp"
#include "tests/messages.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_tilting_planet_test {
namespace {

PlanetaryDrivetrain tilting_reducer() {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.bearing.rollers().laminae = 30;
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
  stiff.bearing.material.youngs_modulus = 206e16;  // of the pin; dry contacts of Palmgren have no modulus
  const PointResult found = evaluate(stiff, derive(stiff));
  drivetrain.seats.tilt = TiltState::stated;
  const PointResult level = evaluate(drivetrain, derive(drivetrain));
  EXPECT_NEAR(found.life_hours / level.life_hours, 1.0, 1e-6);
  EXPECT_NEAR(found.system_life_hours / level.system_life_hours, 1.0, 1e-6);
  ASSERT_EQ(found.seats.size(), 2u);
  EXPECT_NEAR(found.seats[0].life_hours / level.life_hours, 1.0, 1e-6);
}

// Both bearings have the slope of the pin under equal loads as their tilt, in opposite senses; it decreases
// with the load.
TEST(TiltingPlanet, TiltOfTheReducerIsThatOfItsPin) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  for (const double rpm : {1000.0, 6000.0}) {
    drivetrain.drive.speed = rpm * 3.14159265358979 / 30.0;
    const DrivetrainGeometry geometry = derive(drivetrain);
    const PointResult found = evaluate(drivetrain, geometry);
    const std::vector<double> positions = axial_positions(drivetrain);
    const Eigen::MatrixXd bends = bearing::pin_compliance(planet_pin(drivetrain), positions);
    const Eigen::Vector2d load = bearing_duty(drivetrain, geometry).point.bore_load;
    const double slope = (bends(2, 0) + bends(2, 1)) * load.norm();
    ASSERT_EQ(found.seats.size(), 2u);
    EXPECT_LT((found.seats[0].tilt + found.seats[1].tilt).norm(), 1e-6 * slope);
    EXPECT_NEAR(found.seats[0].tilt.norm() / slope, 1.0,
                0.2);  // tilted rollers straighten it, their cage loads it more
  }
}

// A distance of the rows is that of the two bearings of a pair of tapered rollers, and of no other bearings.
TEST(TiltingPlanet, BearingsStandAcrossTheFaceUnlessTheyArePairs) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  const std::vector<double> evenly = axial_positions(drivetrain);
  drivetrain.rows.distance = 40e-3;
  EXPECT_EQ(axial_positions(drivetrain), evenly);
  drivetrain.rows.type = bearing::PlanetBearingType::tapered_roller;
  EXPECT_EQ(axial_positions(drivetrain), (std::vector<double>{-20e-3, 20e-3}));
  drivetrain.rows.distance.reset();
  EXPECT_EQ(axial_positions(drivetrain), evenly);
}

// Load that a cage on the outer ring adds to the bore: its centrifugal force and that of half of the rolling
// elements, whose other half their orbit pushes outward.
TEST(TiltingPlanet, CageOnTheOuterRingPullsWithHalfOfTheElements) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.rows.type = bearing::PlanetBearingType::spherical_roller;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const bearing::OperatingPoint point = bearing_duty(example::reducer(), derive(example::reducer())).point;
  const Eigen::Vector2d added = bore_load_with_cage(drivetrain, geometry, point) - point.bore_load;
  const double mass = geometry.bearing.cage_mass +
                      drivetrain.bearing.element_count() * geometry.bearing.element_mass;  // half of two rows
  const double force = mass * point.carrier.orbit_radius * point.carrier.speed * point.carrier.speed;
  EXPECT_NEAR(added.norm(), force, 1e-12 * force);
}

// The lines of action of sun and ring lean to opposite sides of the tangent: meshes that are alike hold the
// planet about its radius and about its tangent, without coupling between both.
TEST(TiltingPlanet, MeshesThatAreAlikeHoldItAlongItsAxesAlone) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  gearset::dynamics::SetParameters set;
  const double stiffness = 5e8, angle = 0.4;  // [N/m], [rad]
  set.sun_mesh = {.pressure_angle = angle, .stiffness = gearset::PeriodicCurve::constant(stiffness)};
  set.ring_mesh = set.sun_mesh;
  drivetrain.gear_set = [set] { return set; };
  const double both = 2.0 * stiffness * std::pow(drivetrain.set.face_width, 2) / 12.0;  // [N m/rad]
  const Eigen::Matrix2d held = mesh_tilt_stiffness(drivetrain);
  EXPECT_NEAR(held(0, 0) / (both * std::pow(std::sin(angle), 2)), 1.0, 1e-12);
  EXPECT_NEAR(held(1, 1) / (both * std::pow(std::cos(angle), 2)), 1.0, 1e-12);
  EXPECT_LT(std::abs(held(0, 1)), 1e-12 * both);
}

// Forces of both bearings at their positions, their moments and the meshes' springs balance the moment of the
// axial forces of helical teeth on the planet: force of the sun times the distance of both pitch points.
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
    const bearing::laminae::PlanetOnPinResult found =
        tilting_planet(planet_seat(drivetrain), drivetrain, duty);
    const std::vector<double> positions = axial_positions(drivetrain);
    Eigen::Vector2d held = -mesh_tilt_stiffness(drivetrain) * found.tilt;
    for (std::size_t k = 0; k < positions.size(); ++k)
      held += found.bearings[k].moment - positions[k] * found.bearings[k].total_bore_load;
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

// P and P_0 are those of the forces that the bearings carry: the couple of helical teeth loads both of them
// more, though the sum of their forces stays.
TEST(TiltingPlanet, RatesEachBearingUnderTheLoadThatItCarries) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.set.helix_angle = 0.25;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const bearing::laminae::PlanetOnPinResult planet =
      tilting_planet(planet_seat(drivetrain), drivetrain, bearing_duty(drivetrain, geometry));
  const PointResult point = evaluate(drivetrain, geometry);
  constexpr double p = 10.0 / 3.0;
  double sum = 0.0, powers = 0.0, largest = 0.0;
  ASSERT_EQ(point.seats.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const SeatResult& seat = point.seats[k];
    EXPECT_NEAR(seat.load / planet.bearings[k].total_bore_load.norm(), 1.0, 1e-9);
    EXPECT_NEAR(seat.rated_hours.basic * std::pow(seat.load, p) /
                    (point.rating.hours.basic * std::pow(point.rating.lives.dynamic_load, p)),
                1.0, 1e-9);
    sum += seat.load;
    powers += 0.5 * std::pow(seat.load, p);
    largest = std::max(largest, seat.load);
  }
  EXPECT_GT(sum, 2.02 * point.planet_load);
  EXPECT_NEAR(point.rating.lives.dynamic_load / std::pow(powers, 1.0 / p), 1.0, 1e-9);
  EXPECT_NEAR(point.rating.lives.static_load / largest, 1.0, 1e-12);
}

// Flanks of the sun's mesh are on the line (sin a, cos a) from outward to ahead, those of the ring's on (-sin
// a, cos a): across their difference in sense the radial parts of both add up, the mixed ones cancel.
TEST(TiltingPlanet, IsHeldByBothMeshesEachOnItsSide) {
  const PlanetaryDrivetrain drivetrain = tilting_reducer();
  const Eigen::Matrix2d found = mesh_tilt_stiffness(drivetrain);
  const double lever = 28e-3 * 28e-3 / 12.0, sun = 5e8 * lever, ring = 6e8 * lever;  // [N m/rad]
  constexpr double a = 0.33, b = 0.42;
  EXPECT_NEAR(found(0, 0), sun * std::sin(a) * std::sin(a) + ring * std::sin(b) * std::sin(b), 1e-9 * sun);
  EXPECT_NEAR(found(1, 1), sun * std::cos(a) * std::cos(a) + ring * std::cos(b) * std::cos(b), 1e-9 * sun);
  EXPECT_NEAR(found(0, 1), sun * std::sin(a) * std::cos(a) - ring * std::sin(b) * std::cos(b), 1e-9 * sun);
  EXPECT_EQ(found(0, 1), found(1, 0));
}

// Each of a system's lives by the standards is computed from the same lives of its bearings.
TEST(TiltingPlanet, HasASystemsLivesOfTheSameLives) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.seats.clearance_differences = {0.0, 5e-6};
  drivetrain.rated.oil = bearing::rating::StatedOil{.viscosity_ratio = 0.7, .contamination_factor = 0.5};
  const PointResult found = evaluate(drivetrain, derive(drivetrain));
  ASSERT_EQ(found.seats.size(), 2u);
  const auto together = [&](const auto& hours_of) {
    double damage = 0.0;
    for (const SeatResult& seat : found.seats)
      damage += drivetrain.set.planets * std::pow(hours_of(seat), -9.0 / 8.0);
    return std::pow(damage, -8.0 / 9.0);
  };
  EXPECT_NEAR(found.system_life_hours / together([](const SeatResult& seat) { return seat.life_hours; }), 1.0,
              1e-9);
  for (const auto life : bearing::rating::kRatedHours)
    EXPECT_NEAR(found.rating.system_hours.*life /
                    together([&](const SeatResult& seat) { return seat.rated_hours.*life; }),
                1.0, 1e-9);
  EXPECT_GT(found.rating.system_hours.reference, 1.2 * found.rating.system_hours.modified_reference);
}

// The wall at the positive end carries half of what presses on a pin in its middle; N of these halves at the
// centre distance twist it against the other wall, which inclines the pins by the arc over their span.
TEST(TiltingPlanet, FeelsTheTwistOfItsCarrier) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.seats.carrier_twist = 2e5;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const double a = geometry.gears.centre_distance, span = planet_pin(drivetrain).span;
  const double half = duty.gears.tangential_force / 2.0;  // of one planet
  const double inclination = drivetrain.set.planets * half * a / *drivetrain.seats.carrier_twist * a / span;
  const Eigen::MatrixXd compliance = carrier_twist_compliance(drivetrain);
  Eigen::Vector4d loads(half, half, 0.0, 0.0);  // two bearings
  EXPECT_NEAR((compliance * loads)[2] / inclination, 1.0, 1e-9);
  EXPECT_NEAR((compliance * loads)[3] / inclination, 1.0, 1e-9);
  // Mean of both places: the middle of the pin goes along by half of the wall's displacement.
  EXPECT_NEAR((compliance * loads).head<2>().mean() / (0.5 * inclination * span), 1.0, 1e-9);
  // Its effect on the planet is that of an inclined pin.
  const bearing::laminae::PlanetOnPinResult twisted =
      tilting_planet(planet_seat(drivetrain), drivetrain, duty);
  PlanetaryDrivetrain stated = drivetrain;
  stated.seats.carrier_twist.reset();
  const bearing::laminae::PlanetOnPinResult rigid = tilting_planet(planet_seat(stated), stated, duty);
  const double wall = [&] {  // of the loads that are found: bearings no longer carry equal loads
    double force = 0.0;
    const std::vector<double> positions = axial_positions(drivetrain);
    for (std::size_t k = 0; k < 2; ++k)
      force += twisted.bearings[k].total_bore_load.y() * (0.5 + positions[k] / span) +
               twisted.bearings[k].moment.y() / span * -1.0;
    return force;
  }();
  stated.seats.tangential_inclination =
      drivetrain.set.planets * a * a / *drivetrain.seats.carrier_twist * wall / span;
  const bearing::laminae::PlanetOnPinResult inclined = tilting_planet(planet_seat(stated), stated, duty);
  const double change = (twisted.tilt - rigid.tilt).norm();
  EXPECT_GT(change, 1e-6);
  EXPECT_LT((twisted.tilt - inclined.tilt).norm(), 1e-3 * change);
  // If planets carry unequal loads, each is on pins inclined as under their mean load.
  const PlanetSeat unlike = unlike_planet_seat(drivetrain, duty);
  EXPECT_EQ(unlike.tangential_compliance.size(), 0);
  EXPECT_EQ(unlike.pin_inclination.x(), 0.0);
  EXPECT_NEAR(unlike.pin_inclination.y() / stated.seats.tangential_inclination, 1.0, 1e-9);
}

// In motion each bearing keeps the load, the clearance and the tilt of the quasi-static state.
TEST(SeatedBearings, ShareTheLoadOfTheirPlanet) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.seats.clearance_differences = {0.0, 10e-6};
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const std::vector<SeatedBearing> seated =
      seated_bearings(planet_seat(drivetrain), drivetrain, geometry, duty);
  ASSERT_EQ(seated.size(), 2u);
  const Eigen::Vector2d both = seated[0].duty.point.bore_load + seated[1].duty.point.bore_load;
  EXPECT_LT((both - 2.0 * duty.point.bore_load).norm(), 1e-6 * both.norm());
  EXPECT_GT(seated[0].duty.share, 1.2);
  EXPECT_LT(seated[1].duty.share, 0.8);
  EXPECT_NEAR(seated[1].drivetrain.bearing.radial_clearance - seated[0].drivetrain.bearing.radial_clearance,
              10e-6, 1e-12);
  const bearing::laminae::PlanetOnPinResult rest = tilting_planet(planet_seat(drivetrain), drivetrain, duty);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(seated[k].duty.point.bore_tilt, rest.bearing_tilt[k]);
}

// The race of a planet that bends has one form, by what all of its bearings press: that of one bearing in
// motion is made by its own rollers and by what is fixed.
TEST(SeatedBearings, SeeOneFormOfTheirPlanet) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.seats.clearance_differences = {0.0, 10e-6};
  const DrivetrainGeometry geometry = derive(drivetrain);
  BearingDuty duty = bearing_duty(drivetrain, geometry);
  bearing::ElasticRace& race = duty.point.outer_race;
  race.compliance = Eigen::ArrayXd::LinSpaced(4, 4e-10, 1e-10);  // [m/N]
  race.cosine = race.sine = Eigen::ArrayXd::Zero(4);
  const PlanetSeat seat = planet_seat(drivetrain);
  const bearing::laminae::PlanetOnPinResult rest = tilting_planet(seat, drivetrain, duty);
  const std::vector<SeatedBearing> seated = seated_bearings(seat, drivetrain, geometry, duty);
  ASSERT_EQ(seated.size(), 2u);
  Eigen::ArrayXXd form(2, 8);  // (bearing, cosine and sine of each order) [m]
  for (Eigen::Index k = 0; k < 2; ++k) {
    const auto& own = rest.bearings[static_cast<std::size_t>(k)];
    const bearing::ElasticRace& fixed = seated[static_cast<std::size_t>(k)].duty.point.outer_race;
    for (Eigen::Index n = 0; n < 4; ++n) {
      const Eigen::ArrayXd turned = static_cast<double>(n) * own.angle;
      const double by_own = race.compliance[n] / drivetrain.cage_positions;
      form(k, n) = fixed.cosine[n] + by_own * (own.outer_load * turned.cos()).sum();
      form(k, 4 + n) = fixed.sine[n] + by_own * (own.outer_load * turned.sin()).sum();
    }
  }
  const double size = form.abs().maxCoeff();
  EXPECT_GT(std::abs(form(0, 5)), 0.05 * size);  // the load has a component along
  EXPECT_LT((form.row(0) - form.row(1)).abs().maxCoeff(), 1e-9 * size);
  EXPECT_GT(seated[0].duty.point.outer_race.sine.abs().maxCoeff(), 1e-3 * size);
}

TEST(SeatedBearings, LiveInMotionNearlyAsAtRest) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.gear_set = example::coupled_reducer(true).gear_set;  // whose bodies stand, too
  drivetrain.seats.clearance_differences = {0.0, 10e-6};
  drivetrain.mesh_variation = false;
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  drivetrain.steady_state.observed_windows = 6;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const PointResult rest = evaluate(drivetrain, geometry);
  const PointResult motion = evaluate(drivetrain, geometry, Fidelity::dynamic);
  ASSERT_EQ(motion.seats.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(motion.seats[k].tilt, rest.seats[k].tilt);
    EXPECT_NEAR(motion.seats[k].load / rest.seats[k].load, 1.0, 0.02);
    EXPECT_NEAR(motion.seats[k].life_hours / rest.seats[k].life_hours, 1.0, 0.15);
  }
  EXPECT_LT(motion.seats[0].life_hours, motion.seats[1].life_hours);
  EXPECT_REFUSED(std::invalid_argument, "study_tilting_planet 1",
                 evaluate_from(drivetrain, geometry, motion.dynamic->final_state));
}

TEST(TiltingPlanet, WithoutMeshesIsRefused) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.gear_set = nullptr;
  EXPECT_REFUSED(std::invalid_argument, "study_tilting_planet 2", evaluate(drivetrain, derive(drivetrain)));
}

}  // namespace
}  // namespace orbearing::analysis::study_tilting_planet_test
