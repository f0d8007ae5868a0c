// A bearing on a standing carrier is a bearing in a housing: the stationary equations of a radially loaded
// roller bearing with centrifugal load, written here once more from the constants of the sources.
//
//   per roller   (Q_i / K)^0.9 + (Q_o / K)^0.9 = -u . e - G/2   where squeezed;   Q_o = Q_i + m (d_m/2)
//   omega_c^2 outer ring   F + sum Q_o e = 0
//
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::bearing_standing_carrier_test {
namespace {

using constants::pi;

constexpr double kSolved =
    1e-8;  // of the largest load or approach; the solver stops at 1e-9 of the force scale

constexpr double kOuterSpeed = 900.0;  // [rad/s]
constexpr double kClearance = 15e-6;   // [m]

Bearing loose_bearing() {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.radial_clearance = kClearance;
  return bearing;
}

OperatingPoint stationary_carrier() {
  OperatingPoint point = example_bearings::static_load(1500.0, 0.6);
  point.outer_speed = kOuterSpeed;
  point.carrier.orbit_radius = 87.891e-3;  // must not matter
  return point;
}

double centrifugal_load() {
  const double mass = 7850.0 * pi * 2.62e-3 * 2.62e-3 * 5.7e-3;
  const double cage_speed = 0.5 * kOuterSpeed * (1.0 + 5.24 / 35.64);
  return mass * 17.82e-3 * cage_speed * cage_speed;
}

double elastic_approach(double load) {
  const double newton_millimetre = 8.06e4 * std::pow(5.7, 8.0 / 9.0);
  return 1e-3 * std::pow(load / newton_millimetre, 0.9);
}

TEST(StationaryCarrier, FulfilsTheStationaryEquations) {
  const QuasiStaticState state = quasi_static_state(loose_bearing(), stationary_carrier(), {}, 0.05);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  Eigen::Vector2d ring = stationary_carrier().bore_load;
  int squeezed = 0;
  for (Eigen::Index j = 0; j < 15; ++j) {
    const Eigen::Vector2d outward(std::cos(state.angle[j]), std::sin(state.angle[j]));
    const double approach = -state.displacement.dot(outward) - 0.5 * kClearance;
    ring += state.outer_load[j] * outward;
    EXPECT_NEAR(state.outer_load[j] - state.inner_load[j], centrifugal_load(), kSolved * 1500.0);
    if (state.inner_load[j] > 0.0) {
      ++squeezed;
      const double filled = elastic_approach(state.inner_load[j]) + elastic_approach(state.outer_load[j]);
      EXPECT_NEAR(filled, approach, kSolved * approach);
    } else {
      EXPECT_LE(approach, elastic_approach(centrifugal_load()) * (1.0 + kSolved));
    }
  }
  EXPECT_LT(ring.norm(), kSolved * 1500.0);
  EXPECT_GT(squeezed, 1);
  EXPECT_LT(squeezed, 15);
}

TEST(StationaryCarrier, CarrierSwitchesAndTheArmDoNotMatter) {
  const QuasiStaticState all = quasi_static_state(loose_bearing(), stationary_carrier(), {}, 0.05);
  OperatingPoint housing = stationary_carrier();
  housing.carrier.orbit_radius = 0.0;
  QuasiStaticOptions orbit_only;
  orbit_only.inertia = {.own_orbit = true, .coriolis = false, .carrier_centrifugal = false, .euler = false};
  const QuasiStaticState plain = quasi_static_state(loose_bearing(), housing, orbit_only, 0.05);
  EXPECT_EQ((all.outer_load - plain.outer_load).abs().maxCoeff(), 0.0);
  EXPECT_EQ((all.inner_load - plain.inner_load).abs().maxCoeff(), 0.0);
}

// Rotating with carrier and rollers as one rigid body (bore, pin and cage stationary in the carrier), a
// roller has the acceleration Omega^2 times its distance from the sun axis and no other.
TEST(RigidRotation, RollersFeelTheirDistanceFromTheSunAxis) {
  OperatingPoint point = example_bearings::static_load(1500.0, 0.6);
  point.carrier = {.speed = 200.0, .acceleration = 0.0, .orbit_radius = 87.891e-3};
  const QuasiStaticState state = quasi_static_state(loose_bearing(), point, {}, 0.05);
  const double mass = 7850.0 * pi * 2.62e-3 * 2.62e-3 * 5.7e-3;
  for (Eigen::Index j = 0; j < 15; ++j) {
    const double radial = 17.82e-3 + 87.891e-3 * std::cos(state.angle[j]);
    EXPECT_NEAR(state.outer_load[j] - state.inner_load[j], mass * 200.0 * 200.0 * radial, kSolved * 1500.0);
  }
}

// The same rotation given to everything, once as the carrier's and once as the races' own, about the
// bearing's axis.
TEST(RigidRotation, IsTheSameSeenFromTheCarrierOrFromTheGround) {
  OperatingPoint ground = example_bearings::static_load(1500.0, 0.6);
  ground.inner_speed = 300.0;
  ground.outer_speed = 900.0;
  OperatingPoint carrier = ground;
  carrier.carrier.speed = 250.0;
  carrier.inner_speed -= 250.0;
  carrier.outer_speed -= 250.0;
  const QuasiStaticState one = quasi_static_state(loose_bearing(), ground, {}, 0.05);
  const QuasiStaticState other = quasi_static_state(loose_bearing(), carrier, {}, 0.05);
  // Both cages turn at half (900 x 1.147 + 300 x 0.853) rad/s over ground; in the carrier 250 rad/s less.
  EXPECT_LT((one.outer_load - other.outer_load).abs().maxCoeff(), kSolved * 1500.0);
  EXPECT_LT((one.inner_load - other.inner_load).abs().maxCoeff(), kSolved * 1500.0);
}

}  // namespace
}  // namespace orbearing::bearing::bearing_standing_carrier_test
