#include "gearset/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/messages.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::kinematics_test {
namespace {

constexpr double round_off = 1e-13;  // relative

TEST(Kinematics, ReducerTurnsItsCarrierByTheClassicalRatio) {
  const Speeds speeds = member_speeds(reducer(), {Member::sun, 150e3, 116.0});
  EXPECT_NEAR(speeds.carrier, 37.0, 37.0 * round_off);
  EXPECT_EQ(speeds.ring, 0.0);
  EXPECT_EQ(speeds.sun, 116.0);
  EXPECT_NEAR(speeds.planet_relative, -(116.0 - 37.0) * 37.0 / 22.0, 133.0 * round_off);
}

TEST(Kinematics, StandingCarrierReversesTheRing) {
  PlanetarySet set = standard_set();
  set.fixed_member = Member::carrier;
  const Speeds speeds = member_speeds(set, {Member::sun, 1.0, 90.0});
  EXPECT_NEAR(speeds.ring, -30.0, 30.0 * round_off);
  EXPECT_EQ(speeds.carrier, 0.0);
  EXPECT_NEAR(speeds.planet_relative, -90.0, 90.0 * round_off);
}

TEST(Kinematics, FixedSunLetsTheRingDriveTheCarrierSlowly) {
  PlanetarySet set = standard_set();
  set.fixed_member = Member::sun;
  const Speeds speeds = member_speeds(set, {Member::ring, 1.0, 120.0});
  EXPECT_NEAR(speeds.carrier, 90.0, 90.0 * round_off);
  EXPECT_NEAR(speeds.planet_relative, 90.0, 90.0 * round_off);
}

TEST(Kinematics, CarrierDrivesTheSunUp) {
  const Speeds speeds = member_speeds(reducer(), {Member::carrier, 1.0, 37.0});
  EXPECT_NEAR(speeds.sun, 116.0, 116.0 * round_off);
}

TEST(Kinematics, TorqueOfTheDrivenMemberIsPowerOverSpeed) {
  const Torques torques = member_torques(reducer(), {Member::sun, 150e3, 600.0});
  EXPECT_NEAR(torques.sun, 250.0, 250.0 * round_off);
  EXPECT_NEAR(torques.carrier, -250.0 * 116.0 / 37.0, 784.0 * round_off);
  EXPECT_NEAR(torques.ring, 250.0 * 79.0 / 37.0, 534.0 * round_off);
}

TEST(Kinematics, RefusesImpossibleDrives) {
  const PlanetarySet set = reducer();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_REFUSED(std::invalid_argument, "kinematics 1", member_speeds(set, {Member::ring, 1.0, 1.0}));
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    EXPECT_REFUSED(std::invalid_argument, "kinematics 2", member_speeds(set, {Member::sun, 1.0, bad}));
    EXPECT_REFUSED(std::invalid_argument, "kinematics 3", member_torques(set, {Member::sun, bad, 1.0}));
  }
}

}  // namespace
}  // namespace orbearing::gearset::kinematics_test
