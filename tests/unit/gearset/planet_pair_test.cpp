// Planets in pairs, the first in the sun, the second in the first and in the ring.
#include "gearset/planet_pair.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/gear_pair.hpp"
#include "mechanics/constants.hpp"
#include "tests/messages.hpp"

namespace orbearing::gearset::planet_pair_test {
namespace {

using Eigen::Vector2d;

constexpr double round_off = 1e-11;  // relative

/// 30/20/21/84 teeth of module 2 mm without shifts: distances 50, 41 and 63 mm.
PlanetarySet paired_set() {
  return {30, 20, 84, 3, 2e-3, {}, 0.0, 0.0, 20e-3, 15e-3};
}
const SecondPlanet kSecond{.teeth = 21};

PowerFlow flow_of(PlanetarySet set, Member driven) {
  Arrangement arrangement = arrangement_of(set, driven, "set");
  arrangement.sets.front().ring_teeth = willis_teeth_of_pairs(set).ring;
  return power_flow(arrangement);
}

MeanLoads loads_of(const PlanetarySet& set, SecondPlanet pair, bool second, Member driven = Member::sun) {
  return mean_loads_of_planet(set, {pair, second}, flow_of(set, driven).sets[0],
                              {.member = driven, .power = 1200.0, .speed = 120.0});
}

// m/2 times sums and differences of teeth; the axes make a triangle of 50, 63 and 41 mm.
TEST(PlanetPair, HasTheDistancesOfItsMeshes) {
  const PlanetPairGeometry g = planet_pair_geometry(paired_set(), kSecond);
  EXPECT_NEAR(g.first_distance, 50e-3, 1e-12);
  EXPECT_NEAR(g.between, 41e-3, 1e-12);
  EXPECT_NEAR(g.second_distance, 63e-3, 1e-12);
  EXPECT_NEAR(std::cos(g.angle), (50.0 * 50.0 + 63.0 * 63.0 - 41.0 * 41.0) / (2.0 * 50.0 * 63.0), 1e-12);
  const Vector2d second = g.second_distance * Vector2d(std::cos(g.angle), std::sin(g.angle));
  EXPECT_NEAR((second - Vector2d(g.first_distance, 0.0)).norm(), 41e-3, 1e-12);
}

// Willis with the ring held: w_s/w_c = 1 - z_r/z_s = 1 - 84/30 = -1.8. The carrier turns the other way.
TEST(PlanetPair, HasTheSpeedsAndTorquesOfWillis) {
  const PowerFlow flow = flow_of(paired_set(), Member::sun);
  const Speeds& speed = flow.sets[0].speed;
  EXPECT_NEAR(speed.carrier, -1.0 / 1.8, round_off);
  const Torques& torque = flow.sets[0].torque;
  EXPECT_NEAR(torque.ring / torque.sun, -84.0 / 30.0, round_off);
  EXPECT_NEAR(torque.sun + torque.ring + torque.carrier, 0.0, round_off);
  EXPECT_NEAR(torque.sun * speed.sun + torque.carrier * speed.carrier, 0.0, round_off);  // power
  // Teeth that pass each mesh, against the carrier.
  for (const Member driven : {Member::sun, Member::carrier}) {
    const MeanLoads first = loads_of(paired_set(), kSecond, false, driven),
                    second = loads_of(paired_set(), kSecond, true, driven);
    EXPECT_GE(first.carrier_speed, 0.0);
    EXPECT_NEAR((first.sun_speed - first.carrier_speed) * 30.0, -first.planet_speed_relative * 20.0, 1e-9);
    EXPECT_NEAR(first.planet_speed_relative * 20.0, -second.planet_speed_relative * 21.0, 1e-9);
    EXPECT_NEAR(second.planet_speed_relative * 21.0, (first.ring_speed - first.carrier_speed) * 84.0, 1e-9);
  }
}

// The forces of both pins balance the torque of the carrier; along the line of a pair's axes only the
// separating forces differ by the side of the second planet.
TEST(PlanetPair, PinsCarryTheTorqueOfTheCarrier) {
  for (const PairSide side : {PairSide::ahead, PairSide::behind})
    for (const Member driven : {Member::sun, Member::carrier}) {
      SecondPlanet pair = kSecond;
      pair.side = side;
      pair.first_shift = 0.3;
      pair.shift = -0.1;
      const PlanetarySet set = paired_set();
      const PlanetPairGeometry g = planet_pair_geometry(set, pair);
      const MeanLoads first = loads_of(set, pair, false, driven), second = loads_of(set, pair, true, driven);
      EXPECT_NEAR(
          set.planets *
              (g.first_distance * first.tangential_force + g.second_distance * second.tangential_force) /
              -first.carrier_torque,
          1.0, round_off);
      EXPECT_NEAR(first.normal_force * g.sun.base_radius * set.planets, std::abs(first.sun_torque), 1e-9);
      EXPECT_NEAR(first.normal_force * g.ring.base_radius * set.planets, std::abs(first.ring_torque), 1e-9);
    }
}

// Both planets once more by hand, from points of contact: each force along its line of action, which touches
// the base circles, and no moment about the planet's own axis.
TEST(PlanetPair, ForcesGoAlongTheLinesOfAction) {
  const PlanetarySet set = paired_set();
  const PlanetPairGeometry g = planet_pair_geometry(set, kSecond);
  const MeanLoads first = loads_of(set, kSecond, false), second = loads_of(set, kSecond, true);
  const double f = first.normal_force, sense = first.sun_torque > 0.0 ? 1.0 : -1.0;
  const double pressure = 20.0 * constants::degree;  // of all meshes: no shifts
  const Vector2d a(g.first_distance, 0.0),
      b = g.second_distance * Vector2d(std::cos(g.angle), std::sin(g.angle));
  const Vector2d line = (b - a) / g.between, across(-line.y(), line.x());
  const Vector2d sun = f * Vector2d(std::sin(pressure), sense * std::cos(pressure));
  const Vector2d of_second = f * (-std::sin(pressure) * line + sense * std::cos(pressure) * across);
  EXPECT_NEAR(first.radial_force, (sun + of_second).x(), 1e-9 * f);
  EXPECT_NEAR(first.tangential_force, (sun + of_second).y(), 1e-9 * f);
  const Vector2d out = b.normalized(), on(-out.y(), out.x());
  const Vector2d ring = f * (-std::sin(pressure) * out - sense * std::cos(pressure) * on);
  EXPECT_NEAR(second.radial_force, (ring - of_second).dot(out), 1e-9 * f);
  EXPECT_NEAR(second.tangential_force, (ring - of_second).dot(on), 1e-9 * f);
}

// Reversed torque and the other side are mirror images.
TEST(PlanetPair, OtherSideMirrorsTheLoads) {
  SecondPlanet behind = kSecond;
  behind.side = PairSide::behind;
  const PlanetarySet set = paired_set();
  MemberRatios ratios = flow_of(set, Member::sun).sets[0];
  const Drive drive{.member = Member::sun, .power = 1200.0, .speed = 120.0};
  for (const bool second : {false, true}) {
    const MeanLoads one = mean_loads_of_planet(set, {kSecond, second}, ratios, drive);
    MemberRatios reversed = ratios;
    reversed.torque = {-ratios.torque.sun, -ratios.torque.ring, -ratios.torque.carrier};
    const MeanLoads other = mean_loads_of_planet(set, {behind, second}, reversed, drive);
    EXPECT_NEAR(other.radial_force / one.radial_force, 1.0, round_off);
    EXPECT_NEAR(other.tangential_force / one.tangential_force, -1.0, round_off);
  }
}

// (84 - 30)/N is whole for 1, 2, 3, 6, 9; neighbours must have room, and the axes must make a triangle.
TEST(PlanetPair, IsAssembledWhereTeethFit) {
  PlanetarySet set = paired_set();
  EXPECT_TRUE(pair_problems(set, kSecond).empty());
  set.planets = 4;
  ASSERT_FALSE(pair_problems(set, kSecond).empty());
  EXPECT_NE(pair_problems(set, kSecond).front().text.find("a divisor of ring - sun teeth = 54 is required"),
            std::string::npos);
  set = paired_set();
  set.planets = 9;
  ASSERT_FALSE(pair_problems(set, kSecond).empty());
  EXPECT_NE(pair_problems(set, kSecond).front().text.find("neighbouring pairs"), std::string::npos);
  set = paired_set();
  set.ring_teeth = 150;
  EXPECT_NE(pair_problems(set, kSecond).back().text.find("make no triangle"), std::string::npos);
  set = paired_set();
  set.planet_bore = 40e-3;
  EXPECT_NE(pair_problems(set, kSecond).back().text.find("root diameter of both planets"), std::string::npos);
}

// The set of 33/21/23/93 teeth whose ring reaches into the fillets of the second planet: its meshes warn as
// the same teeth do as pairs of two gears.
TEST(PlanetPair, WarnsOfTeethAsTwoGearsDo) {
  PlanetarySet set{33, 21, 93, 3, 4e-3, {}, 0.2, 0.3, 40e-3, 55e-3};
  const SecondPlanet second{.teeth = 23, .first_shift = 0.1, .shift = 0.15, .side = PairSide::behind};
  const Warnings found = pair_tooth_warnings(set, second);
  const GearPair ring{.teeth = {93, 23},
                      .shift = {0.3, 0.15},
                      .module = 4e-3,
                      .face_width = 40e-3,
                      .bore = 55e-3,
                      .kind = InternalPair{}};
  const Warnings alone = pair_warnings(internal_mesh(ring));
  ASSERT_EQ(alone.size(), 1U);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "gearset.profile_shift");
  EXPECT_NE(found[0].text.find("the tips of the ring reach below the second planet's form circle"),
            std::string::npos)
      << found[0].text;
  // Effect on the path: to the form radius, and not to the ring's tips.
  EXPECT_NEAR(planet_pair_geometry(set, second).ring_mesh.contact_ratio, 1.737, 5e-4);
  set.sun_shift = -0.9;  // undercut: 33 teeth need more than -0.93, and the meshes reach deeper
  EXPECT_GE(pair_tooth_warnings(set, second).size(), 1U);
}

// Six pairs: a first planet is 60 - 40.54 degrees from the second one of the previous pair, 23 mm apart; tips
// have radii of 22 and 23 mm, m (z/2 + 1). First planets, 50 mm apart, and second ones, 63 mm, have room.
TEST(PlanetPair, UnlikePlanetsOfNeighboursNeedRoom) {
  PlanetarySet set = paired_set();
  set.planets = 6;
  const double angle =
      constants::pi / 3.0 - std::acos((50.0 * 50.0 + 63.0 * 63.0 - 41.0 * 41.0) / (2.0 * 50.0 * 63.0));
  const double apart = std::sqrt(50.0 * 50.0 + 63.0 * 63.0 - 2.0 * 50.0 * 63.0 * std::cos(angle));  // [mm]
  const Warnings problems = pair_problems(set, kSecond);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().key, "gearset.planets");
  EXPECT_NE(problems.front().text.find(
                fmt::format("axes lie {:.3f} mm apart; more than their tip radii, 45.000 mm", apart)),
            std::string::npos)
      << problems.front().text;
  EXPECT_LT(apart, 45.0);
}

TEST(PlanetPair, EachPlanetHasItsOwnOrbitAndTooth) {
  const PlanetarySet set = paired_set();
  EXPECT_NEAR(geometry_of_planet(set, {kSecond, false}).centre_distance, 50e-3, 1e-12);
  const WorkingGeometry second = geometry_of_planet(set, {kSecond, true});
  EXPECT_NEAR(second.centre_distance, 63e-3, 1e-12);
  EXPECT_EQ(second.planet.teeth, 21);
}

TEST(PlanetPair, RefusesADriveThatStandsStill) {
  const auto loads = [](double power, double speed) {
    return mean_loads_of_planet(paired_set(), {kSecond, false}, flow_of(paired_set(), Member::sun).sets[0],
                                {.member = Member::sun, .power = power, .speed = speed});
  };
  EXPECT_REFUSED(std::invalid_argument, "planet_pair 1", loads(1200.0, 0.0));
  EXPECT_REFUSED(std::invalid_argument, "planet_pair 2", loads(0.0, 120.0));
}

}  // namespace
}  // namespace orbearing::gearset::planet_pair_test
