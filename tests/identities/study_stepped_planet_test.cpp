// Loads of the bearings of a planet with two gears.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "gearset/stepped_planet.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_stepped_planet_test {
namespace {

constexpr double kBalance = 1e-6;  // relative: of the planet's equilibrium

/// The reducer whose planets have their own gear once more, for the ring, behind the first.
PlanetaryDrivetrain stepped_reducer(double offset) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  const double shift = gearset::working_geometry(drivetrain.set).planet_shift;
  drivetrain.set.stepped = {.teeth = drivetrain.set.planet_teeth, .shift = shift, .offset = offset};
  drivetrain.bearing.rollers().laminae = 20;
  drivetrain.seats.tilt = TiltState::computed;
  drivetrain.cage_positions = 4;
  gearset::dynamics::SetParameters set;
  set.sun_mesh = {.pressure_angle = 0.33, .stiffness = gearset::PeriodicCurve::constant(5e8)};
  set.ring_mesh = {.pressure_angle = 0.42, .stiffness = gearset::PeriodicCurve::constant(6e8)};
  drivetrain.gear_set = [set] { return set; };
  return drivetrain;
}

// Forces of both bearings at their places, their moments and the springs of the meshes hold both meshes and
// both gears' pull, whose planes lie 30 mm apart.
TEST(SteppedPlanetOnItsPin, BearingsHoldForcesAndCouple) {
  for (const double offset : {-30e-3, 30e-3}) {
    const PlanetaryDrivetrain drivetrain = stepped_reducer(offset);
    const DrivetrainGeometry geometry = derive(drivetrain);
    const BearingDuty duty = bearing_duty(drivetrain, geometry);
    const bearing::laminae::PlanetOnPinResult found =
        tilting_planet(planet_seat(drivetrain), drivetrain, duty);
    const std::vector<double> positions = axial_positions(drivetrain);
    Eigen::Vector2d held = -mesh_tilt_stiffness(drivetrain) * found.tilt, carried = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < positions.size(); ++k) {
      held += found.bearings[k].moment - positions[k] * found.bearings[k].total_bore_load;
      carried += found.bearings[k].total_bore_load;
    }
    EXPECT_GT(duty.couple.norm(), 10.0);
    EXPECT_LT((held + duty.couple).norm(), kBalance * duty.couple.norm());
    // One bearing carries more than the other.
    EXPECT_GT((found.bearings[0].total_bore_load - found.bearings[1].total_bore_load).norm(),
              0.01 * carried.norm());
  }
}

// Equal gears, one behind the other: forces at -15 and 15 mm, which the sun pushes outward, the ring inward.
TEST(SteppedPlanetOnItsPin, CoupleIsThatOfBothForces) {
  PlanetaryDrivetrain drivetrain = stepped_reducer(30e-3);
  drivetrain.dynamics.inertia.carrier_centrifugal = false;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const double sun = geometry.gears.sun_mesh.working_pressure_angle,
               ring = geometry.gears.ring_mesh.working_pressure_angle;
  const double force = duty.gears.normal_force;
  EXPECT_NEAR(duty.couple.x() / (-15e-3 * force * (std::sin(sun) + std::sin(ring))), 1.0, 1e-9);
  const double sense = duty.gears.tangential_force < 0.0 ? -1.0 : 1.0;
  EXPECT_NEAR(duty.couple.y(), sense * 15e-3 * force * (std::cos(ring) - std::cos(sun)),
              1e-9 * 15e-3 * force);
  // The total is that of the planet with one gear.
  PlanetaryDrivetrain one = drivetrain;
  one.set.stepped = {};
  const BearingDuty of_one = bearing_duty(one, derive(one));
  EXPECT_NEAR(duty.gears.tangential_force / of_one.gears.tangential_force, 1.0, 1e-9);
  EXPECT_EQ(of_one.couple, Eigen::Vector2d::Zero().eval());
}

// Half a turn about the tangential axis exchanges both ends of the planet: the bearings change their roles.
TEST(SteppedPlanetOnItsPin, OffsetTheOtherWayExchangesTheBearings) {
  const PlanetaryDrivetrain one = stepped_reducer(30e-3), other = stepped_reducer(-30e-3);
  const PointResult a = evaluate(one, derive(one)), b = evaluate(other, derive(other));
  ASSERT_EQ(a.seats.size(), 2u);
  EXPECT_NEAR(a.seats[0].life_hours / b.seats[1].life_hours, 1.0, 1e-5);
  EXPECT_NEAR(a.seats[1].life_hours / b.seats[0].life_hours, 1.0, 1e-5);
  EXPECT_NEAR(a.life_hours / b.life_hours, 1.0, 1e-5);
}

}  // namespace
}  // namespace orbearing::analysis::study_stepped_planet_test
