#include "gearset/drivetrain/power_flow.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "gearset/mean_loads.hpp"
#include "tests/messages.hpp"
#include "tests/unit/gearset/arrangements.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::power_flow_test {
namespace {

using namespace example_sets;

constexpr double round_off = 1e-13;  // relative to the largest term

const MemberFlow& flow_of(const PowerFlow& flow, std::size_t set, Member member) {
  return flow.members[3 * set + static_cast<std::size_t>(member)];
}

// The same set by its own kinematics, for every choice of fixed and driven member.
TEST(PowerFlow, OfOneSetIsThatOfItsKinematics) {
  for (const Member fixed : {sun, ring, carrier})
    for (const Member driven : {sun, ring, carrier}) {
      if (fixed == driven) continue;
      PlanetarySet set = gearset::reducer();
      set.fixed_member = fixed;
      const Drive drive{driven, 150e3, 628.0};
      const PowerFlow flow = power_flow(arrangement_of(set, driven, "set"));
      const MeanLoads ours = mean_loads(set, working_geometry(set), flow.sets.front(), drive);
      const MeanLoads simple = mean_loads(set, working_geometry(set), drive);
      const double torque = std::abs(simple.carrier_torque);
      EXPECT_NEAR(ours.sun_speed, simple.sun_speed, round_off * 2000.0);
      EXPECT_NEAR(ours.ring_speed, simple.ring_speed, round_off * 2000.0);
      EXPECT_NEAR(ours.carrier_speed, simple.carrier_speed, round_off * 2000.0);
      EXPECT_NEAR(ours.planet_speed_relative, simple.planet_speed_relative, round_off * 4000.0);
      EXPECT_NEAR(ours.sun_torque, simple.sun_torque, round_off * torque);
      EXPECT_NEAR(ours.tangential_force, simple.tangential_force, round_off * 4.0 * simple.normal_force);
      EXPECT_NEAR(ours.radial_force, simple.radial_force, round_off * simple.normal_force);
    }
}

TEST(PowerFlow, OfSetsInSeriesMultipliesTheirRatios) {
  const PowerFlow flow = power_flow(three_in_series());
  const double first = 1.0 + 79.0 / 37.0;
  const double second = 1.0 + 66.0 / 30.0;
  const double third = 1.0 + 57.0 / 23.0;
  EXPECT_NEAR(flow_of(flow, 1, carrier).speed, 1.0 / (first * second), round_off);
  EXPECT_NEAR(flow_of(flow, 2, carrier).speed, 1.0 / (first * second * third), round_off);
  EXPECT_NEAR(flow_of(flow, 2, sun).torque, first * second, 10.0 * round_off);
  EXPECT_NEAR(flow.shafts[3].torque, -first * second * third, 40.0 * round_off);
  // The housing holds what torque the ratio adds.
  EXPECT_NEAR(flow.shafts[4].torque, first * second * third - 1.0, 40.0 * round_off);
  EXPECT_FALSE(power_circulation(flow).present());
  EXPECT_NEAR(power_circulation(flow).largest_share, 1.0, round_off);
}

// From Willis' equations by hand, [Muller1982]: i = 1 + S1/R1 + S1 R2/(R1 S2). With 28 and 62 teeth 2.45, as
// in the well-known three-speed automatic of the 1960s.
TEST(PowerFlow, OfSimpsonsTrainInLowGear) {
  const PowerFlow flow = power_flow(simpson_low());
  EXPECT_NEAR(1.0 / flow_of(flow, 0, carrier).speed, 2.0 + 28.0 / 62.0, 3.0 * round_off);
  EXPECT_NEAR(flow_of(flow, 0, sun).speed, -(62.0 / 28.0) / (2.0 + 28.0 / 62.0), round_off);
  EXPECT_FALSE(power_circulation(flow).present());
}

// Both carriers joined to the other's ring; by hand i = 1 + (R2/S2) S1/(S1 + R1).
TEST(PowerFlow, OfCrossJoinedCarriersAndRings) {
  const Arrangement train{{arranged("front", 42, 15, 72), arranged("rear", 30, 30, 90)},
                          {motor({{1, sun}}), ground({{0, sun}}), shaft("middle", {{0, carrier}, {1, ring}}),
                           load({{1, carrier}, {0, ring}})}};
  const PowerFlow flow = power_flow(train);
  EXPECT_NEAR(1.0 / flow_of(flow, 1, carrier).speed, 1.0 + (90.0 / 30.0) * 42.0 / (42.0 + 72.0),
              3.0 * round_off);
}

// Two sets that share ring and carrier, as in Ravigneaux's train but with simple planets: both suns turn
// apart.
TEST(PowerFlow, OfSharedRingAndCarrier) {
  const Arrangement train{{arranged("small", 24, 33, 90), arranged("large", 30, 30, 90)},
                          {motor({{0, sun}}), ground({{0, ring}, {1, ring}}),
                           shaft("carriers", {{0, carrier}, {1, carrier}}), load({{1, sun}})}};
  const PowerFlow flow = power_flow(train);
  const double carrier_speed = 24.0 / (24.0 + 90.0);
  EXPECT_NEAR(flow_of(flow, 0, carrier).speed, carrier_speed, round_off);
  EXPECT_NEAR(flow_of(flow, 1, sun).speed, carrier_speed * (30.0 + 90.0) / 30.0, round_off);
}

// By hand: the main carrier turns at (30 - 90*30/60)/120 = -1/8, so its torque is 8; the sun takes 30/120 of
// it.
TEST(PowerFlow, CirculatesThreeTimesTheInput) {
  const PowerFlow flow = power_flow(circulating());
  EXPECT_NEAR(flow_of(flow, 0, carrier).speed, -1.0 / 8.0, round_off);
  EXPECT_NEAR(flow_of(flow, 0, carrier).torque, 8.0, 8.0 * round_off);
  EXPECT_NEAR(flow_of(flow, 0, sun).power, -2.0, 3.0 * round_off);
  EXPECT_NEAR(flow_of(flow, 1, sun).power, 3.0, 3.0 * round_off);
  EXPECT_NEAR(flow_of(flow, 0, ring).power, 3.0, 3.0 * round_off);
  const PowerCirculation circulation = power_circulation(flow);
  ASSERT_TRUE(circulation.present());
  EXPECT_NEAR(circulation.largest_share, 3.0, 3.0 * round_off);
  EXPECT_EQ(circulation.members.size(), 4U);  // both suns and both rings; the carriers carry 1 and 0
}

// A carrier that rotates backwards is the mirrored case: same loads, all senses reversed.
TEST(PowerFlow, TurnsTheFrameWithTheCarrier) {
  const PowerFlow flow = power_flow(circulating());
  const PlanetarySet set = standard_set();
  const MeanLoads loads = mean_loads(set, working_geometry(set), flow.sets.front(), {sun, 800.0, 100.0});
  EXPECT_NEAR(loads.carrier_speed, 100.0 / 8.0, 100.0 * round_off);
  EXPECT_NEAR(loads.carrier_torque, -8.0 * 8.0, 64.0 * round_off);
  EXPECT_GT(loads.tangential_force, 0.0);  // the planets pull the carrier on: it delivers
  EXPECT_REFUSED(std::invalid_argument, "power_flow 1",
                 mean_loads(set, working_geometry(set), flow.sets.front(), {sun, 0.0, 1.0}));
}

TEST(PowerFlow, OfAFaultyArrangementThrowsItsFault) {
  Arrangement faulty = reducer_alone();
  faulty.shafts[1].ground = false;
  EXPECT_REFUSED(std::invalid_argument, "power_flow 2", power_flow(faulty));
  PlanetarySet set = gearset::reducer();
  EXPECT_REFUSED(std::invalid_argument, "power_flow 3", arrangement_of(set, ring, "set"));
}

}  // namespace
}  // namespace orbearing::gearset::power_flow_test
