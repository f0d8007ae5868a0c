// All bearings in motion on planets with a computed quasi-static tilt, and one of several sets in motion by
// itself.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "coupling/analysis/driven_setups.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "coupling/system/monolithic.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "tests/coupled_reducer.hpp"
#include "tests/messages.hpp"

namespace orbearing::analysis::study_seated_motion_test {
namespace {

PlanetaryDrivetrain tilting_reducer() {
  PlanetaryDrivetrain drivetrain = example::coupled_reducer(true);
  drivetrain.dynamics.race.film_in_approach = false;
  drivetrain.mesh_variation = false;
  drivetrain.bearing.rollers().laminae = 10;
  drivetrain.seats.tilt = TiltState::computed;
  drivetrain.seats.clearance_differences = {8e-6, 0.0};
  return drivetrain;
}

// [-]  of the first bearing of a planet over the second
double load_ratio_at_rest(const PlanetaryDrivetrain& drivetrain) {
  const DrivetrainGeometry geometry = derive(drivetrain);
  const std::vector<SeatedBearing> seated = seated_bearings(seat_of_each(drivetrain, geometry), drivetrain,
                                                            geometry, bearing_duty(drivetrain, geometry));
  return seated[0].duty.point.bore_load.norm() / seated[1].duty.point.bore_load.norm();
}

double load_ratio_in_motion(const system::CoupledSetup& setup) {
  system::Monolithic motion(setup);
  motion.initialize(0.0);
  return motion.reaction(0).force.norm() / motion.reaction(1).force.norm();
}

// At one cage angle of each bearing; the quasi-static result is the mean over a roller pitch.
constexpr double kOneAngle = 0.02;

TEST(SeatedMotion, BeginsWithTheLoadsAtRest) {
  const PlanetaryDrivetrain drivetrain = tilting_reducer();
  system::CoupledSetup setup = coupled_setup(drivetrain, derive(drivetrain));
  ASSERT_EQ(setup.seats.size(), 8u);
  const double at_rest = load_ratio_at_rest(drivetrain);
  EXPECT_LT(at_rest, 0.8);
  EXPECT_NEAR(load_ratio_in_motion(setup), at_rest, kOneAngle);
  for (system::BearingSeat& seat : setup.seats) seat.pin_offset.setZero();
  EXPECT_GT(std::abs(load_ratio_in_motion(setup) - at_rest),
            2.0 * kOneAngle);  // effect of the bent pins
}

// Between equal bearings the pins bend evenly: both share the load.
TEST(SeatedMotion, BearingsThatAreAlikeNeedNoOffset) {
  PlanetaryDrivetrain drivetrain = tilting_reducer();
  drivetrain.seats.clearance_differences.clear();
  for (const system::BearingSeat& seat : coupled_setup(drivetrain, derive(drivetrain)).seats)
    EXPECT_LT(seat.pin_offset.norm(), 1e-9);  // [m]
}

TEST(SeatedMotion, EachBearingHasItsSeatInOneSystem) {
  const PlanetaryDrivetrain drivetrain = tilting_reducer();
  system::CoupledSetup setup = coupled_setup(drivetrain, derive(drivetrain));
  EXPECT_REFUSED(std::invalid_argument, "study_seated_motion 2", cosim::planetary_coupling(setup));
  setup.seats.pop_back();
  EXPECT_REFUSED(std::invalid_argument, "study_seated_motion 3", system::coupled_model(setup));
}

TEST(OneOfSeveralSetsInMotion, TurnsAndIsLoadedAsTheSetAlone) {
  const PlanetaryDrivetrain alone = example::coupled_reducer(true);
  PlanetaryDrivetrain arranged = alone;
  arranged.in_arrangement =
      gearset::power_flow(gearset::arrangement_of(alone.set, alone.drive.member, "only")).sets.front();
  const gearset::dynamics::Operation one = driven_gears_setup(alone).operation,
                                     other = driven_gears_setup(arranged).operation;
  constexpr double round_off = 1e-12;
  EXPECT_EQ(other.driven, one.driven);
  EXPECT_NEAR(other.power / one.power, 1.0, round_off);
  EXPECT_NEAR(other.speeds.sun / one.speeds.sun, 1.0, round_off);
  EXPECT_NEAR(other.speeds.carrier / one.speeds.carrier, 1.0, round_off);
  EXPECT_NEAR(other.torques.carrier / one.torques.carrier, 1.0, round_off);
  EXPECT_NEAR(other.mesh_frequency / one.mesh_frequency, 1.0, round_off);
  arranged.set.fixed_member = gearset::Member::carrier;  // which rotates
  EXPECT_REFUSED(std::invalid_argument, "study_seated_motion 1", driven_gears_setup(arranged));
}

}  // namespace
}  // namespace orbearing::analysis::study_seated_motion_test
