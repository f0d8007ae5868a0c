// Two gears on each planet, the first in the sun, the second in the ring.
#include "gearset/stepped_planet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearset/checks.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/mean_loads.hpp"
#include "gearset/planet_body.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::stepped_planet_test {
namespace {

constexpr double round_off = 1e-11;  // relative

/// 30/60 and 20/110 teeth at one distance: m (30 + 60)/2 = 90 mm for module 2, m (110 - 20)/2 = 90 mm for
/// module 2.
PlanetarySet stepped_set() {
  PlanetarySet set{30, 60, 110, 3, 2e-3, {}, 0.0, 0.0, 20e-3, 20e-3};
  set.stepped = {.teeth = 20, .face_width = 30e-3, .offset = 40e-3};
  return set;
}

// Gears of like numbers, modules and shifts on a planet are one gear: speeds, torques, geometry and loads.
TEST(SteppedPlanet, OfLikeGearsIsOneGear) {
  for (const PlanetarySet& one : {reducer(), standard_set()}) {
    const WorkingGeometry of_one = working_geometry(one);
    PlanetarySet two = one;
    two.stepped = {.teeth = one.planet_teeth, .shift = of_one.planet_shift, .offset = one.face_width};
    const WorkingGeometry of_two = working_geometry(two);
    EXPECT_NEAR(of_two.centre_distance / of_one.centre_distance, 1.0, round_off);
    EXPECT_NEAR(of_two.planet_shift, of_one.planet_shift, 1e-9);
    EXPECT_NEAR(of_two.ring_mesh.contact_ratio / of_one.ring_mesh.contact_ratio, 1.0, 1e-9);
    for (const Member driven : {Member::sun, Member::carrier}) {
      const MeanLoads a = mean_loads(one, of_one, {driven, 150e3, 600.0});
      const MeanLoads b = mean_loads(two, of_two, {driven, 150e3, 600.0});
      EXPECT_NEAR(b.carrier_speed / a.carrier_speed, 1.0, round_off);
      EXPECT_NEAR(b.planet_speed_relative / a.planet_speed_relative, 1.0, round_off);
      EXPECT_NEAR(b.ring_torque / a.ring_torque, 1.0, round_off);
      EXPECT_NEAR(b.ring_normal_force / a.normal_force, 1.0, 1e-9);
      EXPECT_NEAR(b.tangential_force / a.tangential_force, 1.0, 1e-9);
      EXPECT_NEAR(b.radial_force, a.radial_force, 1e-8 * a.normal_force);
    }
    EXPECT_EQ(willis_teeth(two).positions(), willis_teeth(one).positions());
  }
}

// By Willis with the ring held: w_s/w_c = 1 + (z_p1 z_r)/(z_s z_p2) = 1 + 60 x 110/(30 x 20) = 12; the planet
// turns by
// -(w_s - w_c) 30/60 = -w_c 110/20 against the carrier.
TEST(SteppedPlanet, HasTheSpeedsOfWillis) {
  const PlanetarySet set = stepped_set();
  const Speeds speeds = member_speeds(set, {Member::sun, 1.0, 120.0});
  EXPECT_NEAR(speeds.carrier, 10.0, 10.0 * round_off);
  EXPECT_NEAR(speeds.planet_relative, -55.0, 55.0 * round_off);
  EXPECT_NEAR(speeds.planet_relative, -speeds.carrier * 110.0 / 20.0, 55.0 * round_off);
  const Torques torques = member_torques(set, {Member::sun, 1200.0, 120.0});
  EXPECT_NEAR(torques.sun, 10.0, 10.0 * round_off);
  EXPECT_NEAR(torques.carrier, -120.0, 120.0 * round_off);
  EXPECT_NEAR(torques.ring, 110.0, 110.0 * round_off);
  // The same by the equations of an arrangement.
  const PowerFlow flow = power_flow(arrangement_of(set, Member::sun, "set"));
  EXPECT_NEAR(12.0 * flow.sets[0].speed.carrier, 1.0, round_off);
  EXPECT_NEAR(flow.sets[0].speed.planet_relative * 120.0, -55.0, 55.0 * round_off);
  EXPECT_NEAR(flow.sets[0].torque.ring, 11.0, 11.0 * round_off);
}

// Both meshes turn the planet by as much in opposite senses, push the carrier on by its torque, and their
// couple about the middle of the planet is that of two forces at their planes.
TEST(SteppedPlanet, IsInBalance) {
  PlanetarySet set = stepped_set();
  set.stepped.module = 2.03e-3;  // (110 - 20) 2.03/2 = 91.35 mm, for which the sun mesh takes shifts
  set.sun_shift = 0.3;
  for (const Member driven : {Member::sun, Member::carrier}) {
    const WorkingGeometry g = working_geometry(set);
    EXPECT_NEAR(g.centre_distance, 91.35e-3, 1e-12);
    const MeanLoads loads = mean_loads(set, g, {driven, 1200.0, 120.0});
    const double sense = loads.sun_torque > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(loads.normal_force * g.sun.base_radius * set.planets, std::abs(loads.sun_torque), 1e-9);
    EXPECT_NEAR(loads.ring_normal_force * g.ring.base_radius * set.planets, std::abs(loads.ring_torque),
                1e-9);
    EXPECT_NEAR(loads.normal_force * g.planet.base_radius / (loads.ring_normal_force * g.second->base_radius),
                1.0, round_off);
    EXPECT_NEAR(loads.tangential_force * set.planets * g.centre_distance / -loads.carrier_torque, 1.0,
                round_off);
    // Gears of 20 and 30 mm, 40 mm apart, reach from -10 to 55 mm: their middles are at -22.5 and 17.5 mm.
    const GearPlanes planes = gear_planes(set);
    EXPECT_NEAR(planes.sun, -22.5e-3, 1e-15);
    EXPECT_NEAR(planes.ring, 17.5e-3, 1e-15);
    EXPECT_NEAR(planes.length, 65e-3, 1e-15);
    const double sun = g.sun_mesh.working_pressure_angle, ring = g.ring_mesh.working_pressure_angle;
    EXPECT_NEAR(loads.couple_ahead,
                sense * (-22.5e-3 * loads.normal_force * std::cos(sun) +
                         17.5e-3 * loads.ring_normal_force * std::cos(ring)),
                1e-9);
    EXPECT_NEAR(
        loads.couple_outward,
        -22.5e-3 * loads.normal_force * std::sin(sun) - 17.5e-3 * loads.ring_normal_force * std::sin(ring),
        1e-9);
  }
}

// The other end of the planet: the couple changes its sign.
TEST(SteppedPlanet, OffsetTheOtherWayMirrorsTheCouple) {
  PlanetarySet set = stepped_set();
  const WorkingGeometry g = working_geometry(set);
  const MeanLoads one = mean_loads(set, g, {Member::sun, 1200.0, 120.0});
  set.stepped.offset *= -1.0;
  const MeanLoads other = mean_loads(set, g, {Member::sun, 1200.0, 120.0});
  EXPECT_NEAR(other.couple_ahead / one.couple_ahead, -1.0, round_off);
  EXPECT_NEAR(other.couple_outward / one.couple_outward, -1.0, round_off);
  EXPECT_EQ(other.tangential_force, one.tangential_force);
}

// Equal planets find their spaces where psi (z_s z_p2 + z_r z_p1)/(2 pi gcd) is whole: here (30 x 20 + 110 x
// 60)/20 = 360.
TEST(SteppedPlanet, FindsItsSpacesAtItsOwnSteps) {
  PlanetarySet set = stepped_set();
  EXPECT_EQ(willis_teeth(set).positions(), 360);
  EXPECT_TRUE(assembly_problems(set).empty());
  set.planets = 7;
  ASSERT_FALSE(assembly_problems(set).empty());
  EXPECT_NE(assembly_problems(set).front().text.find("found 7 equally spaced stepped planets"),
            std::string::npos);
  EXPECT_NE(assembly_problems(set).front().text.find("= 360 is required"), std::string::npos);
}

TEST(SteppedPlanet, WeighsAsBothGears) {
  const PlanetarySet set = stepped_set();
  const WorkingGeometry g = working_geometry(set);
  const PlanetBody body = planet_body(set, g);
  const double first = set.density * 20e-3 * section_moments(g.planet, 10e-3).area;
  const double second = set.density * 30e-3 * section_moments(*g.second, 10e-3).area;
  EXPECT_NEAR(body.mass / (first + second), 1.0, round_off);
  EXPECT_NEAR(body.first_moment / (-22.5e-3 * first + 17.5e-3 * second), 1.0, 1e-9);
}

TEST(SteppedPlanet, SunOutOfReachIsAProblem) {
  PlanetarySet set = stepped_set();
  set.stepped.module = 1e-3;  // 45 mm
  const Warnings problems = assembly_problems(set);
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems.front().text.find("at which sun and first gear cannot mesh"), std::string::npos);
}

}  // namespace
}  // namespace orbearing::gearset::stepped_planet_test
