// Issue 16, Build 3: a parallel stage in front of or behind planetary sets.
#include <gtest/gtest.h>

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
    drive.parallel.front = {20, 63};
    const MeanLoads loads = mean_loads(set, geometry, drive);
    EXPECT_NEAR(loads.normal_force / alone.normal_force, 63.0 / 20.0, round_off);
    EXPECT_NEAR(loads.tangential_force / alone.tangential_force, 63.0 / 20.0, round_off);
    EXPECT_NEAR(loads.carrier_speed / alone.carrier_speed, 20.0 / 63.0, round_off);
    EXPECT_NEAR(loads.planet_speed_relative / alone.planet_speed_relative, 20.0 / 63.0, round_off);
    drive.parallel.behind = {50, 17};  // what lies behind does not come back
    EXPECT_EQ(mean_loads(set, geometry, drive).normal_force, loads.normal_force);
  }
}

// The same by the equations of the whole arrangement, with the sense of rotation and the housing's share.
TEST(ParallelStage, IsASetWhoseCarrierIsTheHousing) {
  const PlanetarySet set = with_helix(reducer(), 0.2);
  const WorkingGeometry geometry = working_geometry(set);
  Drive drive{Member::sun, 150e3, 600.0};
  drive.parallel = {{20, 63}, {50, 17}};
  const Arrangement all = with_parallel_stages(arrangement_of(set, Member::sun, "set"), drive.parallel);
  const PowerFlow flow = power_flow(all);
  ASSERT_EQ(flow.sets.size(), 3u);
  EXPECT_NEAR(flow.sets[0].speed.sun, -20.0 / 63.0, round_off);
  EXPECT_NEAR(flow.sets[0].torque.sun, -63.0 / 20.0, round_off);
  // The load turns backwards twice: -50/17 of the carrier, which turns backwards itself.
  const double carrier = -20.0 / 63.0 * set.sun_teeth / (set.sun_teeth + set.ring_teeth);
  EXPECT_NEAR(flow.sets[2].speed.ring / carrier, -50.0 / 17.0, round_off);
  EXPECT_EQ(flow.sets[2].speed.carrier, 0.0);
  // Torques of both gears and the housing are in balance.
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

TEST(ParallelStage, OfLikeGearsIsNone) {
  const Arrangement set = arrangement_of(reducer(), Member::sun, "set");
  EXPECT_EQ(with_parallel_stages(set, {}).sets.size(), 1u);
  EXPECT_EQ(Drive({Member::sun, 1.0, 600.0}).driven_speed(), 600.0);
}

TEST(ParallelStage, NamesItsMembers) {
  const Arrangement all =
      with_parallel_stages(arrangement_of(reducer(), Member::sun, "set"), {{20, 63}, {1, 1}});
  EXPECT_EQ(name_of(all, {1, Member::sun}), "front.first");
  EXPECT_EQ(name_of(all, {1, Member::ring}), "front.second");
  EXPECT_EQ(name_of(all, {1, Member::carrier}), "front.housing");
  EXPECT_EQ(name_of(all, {0, Member::ring}), "set.ring");
}

}  // namespace
}  // namespace orbearing::gearset::parallel_stage_test
