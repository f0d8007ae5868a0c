// A parallel stage in front of or behind planetary sets.
#include <gtest/gtest.h>

#include <vector>

#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/mean_loads.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::parallel_stage_test {
namespace {

constexpr double round_off = 1e-12;  // relative

// "a parallel stage in front changes planet loads by Willis' and torque balance exactly": z_1 w_1 = z_2 w_2
// in size, and the power stays.
TEST(ParallelStage, InFrontChangesLoadsByItsRatio) {
  const PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  for (const Member driven : {Member::sun, Member::carrier}) {
    const MeanLoads alone = mean_loads(set, geometry, {driven, 150e3, 600.0});
    Drive drive{driven, 150e3, 600.0};
    drive.parallel.front = {{20, 63}};
    const MeanLoads loads = mean_loads(set, geometry, drive);
    EXPECT_NEAR(loads.normal_force / alone.normal_force, 63.0 / 20.0, round_off);
    EXPECT_NEAR(loads.tangential_force / alone.tangential_force, 63.0 / 20.0, round_off);
    EXPECT_NEAR(loads.carrier_speed / alone.carrier_speed, 20.0 / 63.0, round_off);
    EXPECT_NEAR(loads.planet_speed_relative / alone.planet_speed_relative, 20.0 / 63.0, round_off);
    drive.parallel.behind = {{50, 17}};  // what lies behind does not come back
    EXPECT_EQ(mean_loads(set, geometry, drive).normal_force, loads.normal_force);
  }
}

// The same by the equations of the whole arrangement, with the sense of rotation and the housing's share.
TEST(ParallelStage, IsASetWhoseCarrierIsTheHousing) {
  const PlanetarySet set = with_helix(reducer(), 0.2);
  const WorkingGeometry geometry = working_geometry(set);
  Drive drive{Member::sun, 150e3, 600.0};
  drive.parallel = {{{20, 63}}, {{50, 17}}};
  const Arrangement all = with_parallel_stages(arrangement_of(set, Member::sun, "set"), drive.parallel);
  const PowerFlow flow = power_flow(all);
  ASSERT_EQ(flow.sets.size(), 3u);
  EXPECT_NEAR(flow.sets[0].speed.sun, -20.0 / 63.0, round_off);
  EXPECT_NEAR(flow.sets[0].torque.sun, -63.0 / 20.0, round_off);
  // The load turns backwards twice: -50/17 of the carrier, which turns backwards itself.
  const double carrier = -20.0 / 63.0 * set.sun_teeth / (set.sun_teeth + set.ring_teeth);
  EXPECT_NEAR(flow.sets[2].speed.ring / carrier, -50.0 / 17.0, round_off);
  EXPECT_EQ(flow.sets[2].speed.carrier, 0.0);
  // Torques of both gears and the housing are in equilibrium.
  EXPECT_NEAR(flow.sets[1].torque.sun + flow.sets[1].torque.ring + flow.sets[1].torque.carrier, 0.0,
              10.0 * round_off);
  EXPECT_NEAR(flow.sets[1].torque.carrier, -(1.0 + 63.0 / 20.0), 10.0 * round_off);
  for (const MemberFlow& member : flow.members) {
    const bool housing = all.sets[member.member.set].is_parallel() && member.member.member == Member::carrier;
    EXPECT_EQ(member.power == 0.0, housing || member.member == (SetMember{0, Member::ring}));
  }
  EXPECT_FALSE(power_circulation(flow).present());
  // Both ways to the loads of the planets.
  const MeanLoads single = mean_loads(set, geometry, drive);
  const MeanLoads arranged = mean_loads(set, geometry, flow.sets[0], drive);
  EXPECT_NEAR(arranged.normal_force / single.normal_force, 1.0, round_off);
  EXPECT_NEAR(arranged.tangential_force / single.tangential_force, 1.0, round_off);
  EXPECT_NEAR(arranged.carrier_speed / single.carrier_speed, 1.0, round_off);
  EXPECT_NEAR(arranged.axial_force / single.axial_force, 1.0, round_off);
}

TEST(ParallelStage, OfOneToothEachIsNone) {
  const Arrangement set = arrangement_of(reducer(), Member::sun, "set");
  EXPECT_EQ(with_parallel_stages(set, {}).sets.size(), 1u);
  EXPECT_EQ(Drive({Member::sun, 1.0, 600.0}).driven_speed(), 600.0);
}

// The 750 kW gearbox of [Keller2018] by hand: 22.1 rpm x (21 + 99)/21 = 126.286 of the sun, x 82/23 =
// 450.236, x 88/22 = 1800.94 rpm; torques fall as the speeds grow, and what enters leaves.
TEST(ParallelStage, SeveralFollowEachOther) {
  const PlanetarySet set{.sun_teeth = 21, .planet_teeth = 39, .ring_teeth = 99, .planets = 3};
  const Arrangement all =
      with_parallel_stages(arrangement_of(set, Member::carrier, "set"), {{{1, 1}}, {{82, 23}, {88, 22}}});
  const PowerFlow flow = power_flow(all);
  ASSERT_EQ(flow.sets.size(), 3u);
  EXPECT_EQ(all.sets[1].name, "behind_1");
  EXPECT_EQ(all.sets[2].name, "behind_2");
  const double sun = 120.0 / 21.0, middle = -sun * 82.0 / 23.0, out = sun * 82.0 * 88.0 / (23.0 * 22.0);
  EXPECT_NEAR(flow.sets[1].speed.sun / sun, 1.0, round_off);
  EXPECT_NEAR(flow.sets[1].speed.ring / middle, 1.0, round_off);
  EXPECT_NEAR(flow.sets[2].speed.sun / middle, 1.0, round_off);
  EXPECT_NEAR(flow.sets[2].speed.ring / out, 1.0, round_off);
  EXPECT_NEAR(out, 81.491, 5e-4);  // digits of the source
  EXPECT_NEAR(22.1 * out, 1800.9, 0.05);
  EXPECT_NEAR(flow.sets[1].torque.ring * middle, -1.0, 10.0 * round_off);
  EXPECT_NEAR(flow.sets[2].torque.sun * middle, 1.0, 10.0 * round_off);
  double entering = 0.0, leaving = 0.0;
  for (const ShaftFlow& shaft : flow.shafts) (shaft.power > 0.0 ? entering : leaving) += shaft.power;
  EXPECT_NEAR(entering, 1.0, 10.0 * round_off);
  EXPECT_NEAR(leaving, -1.0, 10.0 * round_off);
  EXPECT_FALSE(power_circulation(flow).present());
}

// In front the first is driven by the motor and the last drives the set: each has the speed and, by its
// power, the torque of its own place.
TEST(ParallelStage, SeveralInFrontFollowEachOther) {
  const PlanetarySet set{.sun_teeth = 21, .planet_teeth = 39, .ring_teeth = 99, .planets = 3};
  const PowerFlow flow = power_flow(
      with_parallel_stages(arrangement_of(set, Member::sun, "set"), {{{23, 82}, {22, 88}}, {{1, 1}}}));
  ASSERT_EQ(flow.sets.size(), 3u);
  const double middle = -23.0 / 82.0, sun = 23.0 * 22.0 / (82.0 * 88.0);
  EXPECT_NEAR(flow.sets[1].speed.sun, 1.0, round_off);
  EXPECT_NEAR(flow.sets[1].speed.ring / middle, 1.0, round_off);
  EXPECT_NEAR(flow.sets[2].speed.sun / middle, 1.0, round_off);
  EXPECT_NEAR(flow.sets[2].speed.ring / sun, 1.0, round_off);
  EXPECT_NEAR(flow.sets[0].speed.sun / sun, 1.0, round_off);
  EXPECT_NEAR(flow.sets[1].torque.sun, 1.0, 10.0 * round_off);
  EXPECT_NEAR(flow.sets[2].torque.sun * middle, 1.0, 10.0 * round_off);
  EXPECT_NEAR(flow.sets[0].torque.sun * sun, 1.0, 10.0 * round_off);
}

// Whatever the order, the side of the set and the number of stages: the ratio is the product.
TEST(ParallelStage, OrderDoesNotChangeTheOverallRatio) {
  const PlanetarySet set = reducer();
  const std::vector<StageTeeth> stages{{20, 63}, {88, 22}, {31, 30}, {40, 40}};
  const auto load_speed = [&](const ParallelStages& parallel) {
    const Arrangement all = with_parallel_stages(arrangement_of(set, Member::sun, "set"), parallel);
    const PowerFlow flow = power_flow(all);
    for (std::size_t i = 0; i < all.shafts.size(); ++i)
      if (all.shafts[i].load) return flow.shafts[i].speed;
    ADD_FAILURE() << "no shaft with the load";
    return 0.0;
  };
  const double alone = load_speed({});
  double product = alone;
  for (const StageTeeth& teeth : stages) product *= -double(teeth[0]) / teeth[1];
  EXPECT_NEAR(load_speed({stages, {}}) / product, 1.0, round_off);
  EXPECT_NEAR(load_speed({{}, stages}) / product, 1.0, round_off);
  const std::vector<StageTeeth> reversed(stages.rbegin(), stages.rend());
  EXPECT_NEAR(load_speed({{}, reversed}) / product, 1.0, round_off);
  EXPECT_NEAR(load_speed({{stages[2], stages[0]}, {stages[3], stages[1]}}) / product, 1.0, round_off);
  // Those in front make the speed of the driven member, whatever their order.
  Drive drive{Member::sun, 150e3, 600.0};
  drive.parallel.front = stages;
  const double driven = drive.driven_speed();
  EXPECT_NEAR(driven, 600.0 * 20.0 * 88.0 * 31.0 / (63.0 * 22.0 * 30.0), 600.0 * round_off);
  drive.parallel.front = reversed;
  EXPECT_NEAR(drive.driven_speed() / driven, 1.0, round_off);
}

// Alike gears turn the sense of rotation and nothing else.
TEST(ParallelStage, OfLikeGearsTurnsTheSense) {
  const Arrangement all =
      with_parallel_stages(arrangement_of(reducer(), Member::sun, "set"), {{{30, 30}}, {}});
  const PowerFlow flow = power_flow(all);
  ASSERT_EQ(flow.sets.size(), 2u);
  EXPECT_NEAR(flow.sets[0].speed.sun, -1.0, round_off);
  EXPECT_NEAR(flow.sets[0].torque.sun, -1.0, round_off);
}

TEST(ParallelStage, NamesItsMembers) {
  const Arrangement all =
      with_parallel_stages(arrangement_of(reducer(), Member::sun, "set"), {{{20, 63}}, {{1, 1}}});
  EXPECT_EQ(name_of(all, {1, Member::sun}), "front.first");
  EXPECT_EQ(name_of(all, {1, Member::ring}), "front.second");
  EXPECT_EQ(name_of(all, {1, Member::carrier}), "front.housing");
  EXPECT_EQ(name_of(all, {0, Member::ring}), "set.ring");
}

}  // namespace
}  // namespace orbearing::gearset::parallel_stage_test
