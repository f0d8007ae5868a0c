// Groups of any number of rows, and a duplex pair at speed.
#include "bearing/equilibrium/row_group.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bearing/duplex/shaft.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::equilibrium::row_group_test {
namespace {

constexpr double kDegree = constants::degree;
constexpr double kRpm = constants::pi / 30.0;

Bearing angular_balls() {
  return {.inner = {.osculation = 0.5232},
          .outer = {.osculation = 0.5232},
          .elements = Balls{.count = 16, .diameter = 22.23e-3, .contact_angle = 40.0 * kDegree},
          .pitch_diameter = 125.26e-3};
}

Bearing rollers() {
  Bearing bearing{
      .elements = CylindricalRollers{.count = 14, .diameter = 12e-3, .length = 12e-3, .laminae = 11},
      .pitch_diameter = 70e-3};
  bearing.radial_clearance = 10e-6;
  return bearing;
}

RowOnShaft row(double rpm, double position, double side, double approach) {
  return {.bearing = angular_balls(),
          .motion = {.speeds = {.inner = rpm * kRpm}},
          .position = position,
          .side = side,
          .approach = approach};
}

// Two bearings side by side that lean against each other, and rollers at the other end of the shaft.
std::vector<RowOnShaft> spindle(double rpm) {
  return {row(rpm, 0.06, 1.0, 40e-6), row(rpm, 0.03, -1.0, 40e-6), {.bearing = rollers(), .position = -0.15}};
}

TEST(RowGroup, OneRowIsTheBearing) {
  const RingLoad load{.radial = 4000.0, .axial = 17800.0, .moment = 50.0, .moment_across = 20.0};
  for (const double rpm : {0.0, 9000.0}) {
    const RowOnShaft one = row(rpm, 0.0, 1.0, 0.0);
    const RingState alone = balance_bearing(one.bearing, one.motion, load), state = balance_rows({one}, load);
    ASSERT_TRUE(state.report.converged);
    EXPECT_NEAR(state.axial / alone.axial, 1.0, 1e-10);
    EXPECT_LT((state.stiffness - alone.stiffness).norm(), 1e-9 * alone.stiffness.norm());
    EXPECT_LT((state.contact_load - alone.contact_load).matrix().norm(), 1e-9 * alone.contact_load.sum());
  }
}

// A mirrored row bears the mirrored load, and one aside the load with its moment.
TEST(RowGroup, ARowAsideAndMirroredIsTheBearingUnderTheMovedLoad) {
  constexpr double aside = 0.08;  // [m]
  const RingLoad load{.radial = 3000.0, .axial = 15000.0, .moment = 40.0};
  for (const double rpm : {0.0, 9000.0}) {
    const RingState alone = balance_rows({row(rpm, 0.0, 1.0, 0.0)}, load);
    const RingState moved = balance_rows(
        {row(rpm, aside, -1.0, 0.0)},
        {.radial = load.radial, .axial = -load.axial, .moment = -load.moment - aside * load.radial});
    ASSERT_TRUE(moved.report.converged);
    EXPECT_NEAR(moved.axial / alone.axial, -1.0, 1e-9);
    EXPECT_NEAR(moved.tilt / alone.tilt, -1.0, 1e-8);
    EXPECT_LT((moved.contact_load - alone.contact_load).matrix().norm(), 1e-8 * alone.contact_load.sum());
  }
}

TEST(RowGroup, EveryEntryOfTheStiffnessOfThreeRowsIsASlopeOfTheForces) {
  const RingLoad load{.radial = 5000.0, .axial = 2000.0, .moment = 100.0, .moment_across = -60.0};
  for (const double rpm : {0.0, 9000.0}) {
    const RingState state = balance_rows(spindle(rpm), load);
    ASSERT_TRUE(state.report.converged) << state.report.message;
    EXPECT_EQ(state.contact_load.size(), 16 + 16 + 14);
    const RowGroup group(RowGroup(spindle(rpm)), spindle(rpm));
    const RingPosition position = position_of(state, group.lever());
    const RingImbalance here = row_forces(group, position);
    EXPECT_LT((here.force + outer_load(load, group.lever())).norm(), 1e-9 * here.scale);
    EXPECT_LT((by_tilt(here.stiffness, group.lever()) - state.stiffness).norm(),
              1e-7 * state.stiffness.norm());
    for (int i = 0; i < 5; ++i) {
      const RingPosition step = 2e-9 * RingPosition::Unit(i);  // [m]
      const RingPosition slope =
          (row_forces(group, position - step).force - row_forces(group, position + step).force) / 4e-9;
      EXPECT_LT((slope - here.stiffness.col(i)).norm(), 1e-6 * here.stiffness.norm()) << i << " at " << rpm;
    }
  }
}

// A pair preloaded by spacers on a shaft: at zero speed the pair of bearing/duplex; at speed balls have
// centrifugal loads, inner contact angles grow, and the natural frequencies with them or against them; forces
// still close.
TEST(RowGroup, ADuplexPairAtSpeedHasItsOwnNaturalFrequencies) {
  const duplex::Shaft shaft{.mass = 12.0, .levers = {0.03, 0.03}, .inertia_x = 0.05, .inertia_y = 0.05};
  const duplex::Pair pair{.bearing = angular_balls(),
                          .arrangement = duplex::Arrangement::back_to_back,
                          .levers = shaft.levers,
                          .approach = 30e-6};
  const auto pair_at = [&](double rpm) {
    return duplex::balance_pair_at_speed(pair, {.speeds = {.inner = rpm * kRpm}});
  };
  const duplex::PairModes of_pair = duplex::modes_of(duplex::balance_pair(pair).ring.stiffness, shaft);
  const duplex::PairModes at_rest = duplex::modes_of(pair_at(0.0).stiffness, shaft);
  const duplex::PairModes slow = duplex::modes_of(pair_at(1.0).stiffness, shaft);
  const RingState fast_state = pair_at(10000.0);
  ASSERT_TRUE(fast_state.report.converged);
  const duplex::PairModes fast = duplex::modes_of(fast_state.stiffness, shaft);
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    EXPECT_NEAR(at_rest[i].frequency / of_pair[i].frequency, 1.0, 1e-9) << i;
    EXPECT_NEAR(slow[i].frequency / at_rest[i].frequency, 1.0, 1e-5) << i;
    EXPECT_GT(std::abs(fast[i].frequency / at_rest[i].frequency - 1.0), 0.01) << i;
    const std::string name = duplex::name_of(at_rest[i].kind);
    RecordProperty(name + "_at_rest_Hz", std::to_string(at_rest[i].frequency));
    RecordProperty(name + "_at_speed_Hz", std::to_string(fast[i].frequency));
  }
  EXPECT_GT(fast_state.contact_angle.abs().minCoeff(), fast_state.outer_angle.abs().maxCoeff());
}

// Each row of a tandem keeps its load: centrifugal loads of balls leave the sum of the axial forces
// unchanged.
TEST(RowGroup, ATandemAtSpeedKeepsItsPreload) {
  const duplex::Pair pair{.bearing = angular_balls(),
                          .arrangement = duplex::Arrangement::tandem,
                          .levers = {0.03, 0.03},
                          .approach = 30e-6};
  const auto axial_force = [](const RingState& state) {
    return (state.contact_load * state.contact_angle.sin()).sum();
  };
  const RingState fast = duplex::balance_pair_at_speed(
      pair, {.speeds = {.inner = 10000.0 * kRpm}, .inertia = {.gyroscopic_moment = GyroscopicMoment::none}});
  ASSERT_TRUE(fast.report.converged);
  EXPECT_NEAR(axial_force(fast) / axial_force(duplex::balance_pair(pair).ring), 1.0, 1e-9);
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::row_group_test
