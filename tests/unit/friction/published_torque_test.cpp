// Friction torque by formulas of other sources, against values by hand.
#include "bearing/friction/published_torque.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/friction/thermal_reference.hpp"

namespace orbearing::bearing::friction::published_torque_test {
namespace {

constexpr double kRpm = 3.14159265358979324 / 30.0;  // [rad/s]
constexpr double kByHand = 2e-4;                     // relative: digits of the values by hand
constexpr double kTwoDigits = 0.005;                 // of factors printed as 0.85 and 0.8

// NU 204: 20 x 47 x 14 mm, C_0 22 kN.
BearingSize roller_bearing() {
  return {TorqueFamily::cylindrical, 20e-3, 47e-3, 14e-3, 22e3, 2, false};
}
// 6205: 25 x 52 x 15 mm, C_0 7.8 kN.
BearingSize ball_bearing() {
  return {TorqueFamily::deep_groove, 25e-3, 52e-3, 15e-3, 7.8e3, 2, false};
}
TorqueCondition at(double rpm, double mm2_s, double radial, double axial = 0.0) {
  return {rpm * kRpm, mm2_s * 1e-6, radial, axial};
}

// (12 x 17000)^(2/3) = 3465.5, 33.5^3 = 37595: 1e-7 x 2 x 3465.5 x 37595 = 26.057 N mm; 0.0003 x 1100 N
// x 33.5 mm.
TEST(PalmgrenTorque, OfARollerBearingByHand) {
  const TorqueCondition run = at(17000.0, 12.0, 1100.0);
  const TorqueParts torque = torque_parts(palmgren_factors(roller_bearing(), run), 33.5e-3, run);
  EXPECT_NEAR(torque.load_free, 26.057e-3, kByHand * 26.057e-3);
  EXPECT_NEAR(torque.load_dependent, 11.055e-3, kByHand * 11.055e-3);
}

// For balls f_1 grows with the root of the load: 0.0009 (390/7800)^0.5 = 2.0125e-4, x 390 N x 38.5 mm.
TEST(PalmgrenTorque, OfABallBearingByHand) {
  const TorqueCondition run = at(28000.0, 12.0, 390.0);
  const TorqueParts torque = torque_parts(palmgren_factors(ball_bearing(), run), 38.5e-3, run);
  EXPECT_NEAR(torque.load_dependent, 3.0217e-3, kByHand * 3.0217e-3);
}

// Below nu n = 2000 mm^2/s rpm M_0 does not depend on the speed; there it jumps by 160/2000^(2/3) = 1.008.
TEST(PalmgrenTorque, IsConstantAtLowSpeed) {
  const TorqueFactors factors{.load_free = 2.0};
  const double slow = torque_parts(factors, 40e-3, at(100.0, 10.0, 0.0)).load_free,
               slower = torque_parts(factors, 40e-3, at(10.0, 10.0, 0.0)).load_free;
  EXPECT_DOUBLE_EQ(slow, slower);
  EXPECT_NEAR(slow, 160e-7 * 2.0 * 64e3 * 1e-3, 1e-12);
}

// A heavy axial load has the factor 3.3 on balls, and never counts less than the radial one.
TEST(PalmgrenTorque, TakesAxialLoadsOfBalls) {
  EXPECT_DOUBLE_EQ(palmgren_factors(ball_bearing(), at(1.0, 1.0, 100.0, 1000.0)).load, 3290.0);
  EXPECT_DOUBLE_EQ(palmgren_factors(ball_bearing(), at(1.0, 1.0, 100.0, 10.0)).load, 100.0);
}

// [SKF6000], page 104, example: d 40, D 80 mm, 3500 rpm, 68 mm^2/s, K_Z 5.5: 0.85 and 0.8.
TEST(SkfTorque, FactorsOfItsOwnExample) {
  const TorqueCondition run = at(3500.0, 68.0, 2990.0);
  EXPECT_NEAR(inlet_heating_factor(60e-3, run), 0.85, kTwoDigits);
  EXPECT_NEAR(starvation_factor(40e-3, 80e-3, 5.5, run), 0.8, kTwoDigits);
}

// G_rr = 1.09e-6 x 33.5^2.41 x 1100^0.31 = 4.5265e-2, (12 x 17000)^0.6 = 1531.3, phi_ish = 0.82443, phi_rs =
// 0.88154: 50.375 N mm; full film 0.02 x 0.0015 x 33.5 x 1100 = 1.1055 N mm.
TEST(SkfTorque, OfARollerBearingByHand) {
  const SkfTorque torque = skf_torque(roller_bearing(), at(17000.0, 12.0, 1100.0));
  const double g = 1.09e-6 * std::pow(33.5, 2.41) * std::pow(1100.0, 0.31);
  const double heating = 1.0 / (1.0 + 1.84e-9 * std::pow(17000.0 * 33.5, 1.28) * std::pow(12.0, 0.64));
  const double starvation = std::exp(-3e-8 * 12.0 * 17000.0 * 67.0 * std::sqrt(5.1 / 54.0));
  EXPECT_NEAR(torque.rolling, 1e-3 * heating * starvation * g * std::pow(204000.0, 0.6), 1e-12);
  EXPECT_NEAR(torque.sliding, 1.1055e-3, kByHand * 1.1055e-3);
  EXPECT_LT(torque.boundary_share, 1e-10);
}

// A trace of axial load changes nothing of the rolling part; at zero speed the boundary carries all: mu =
// 0.15.
TEST(SkfTorque, HasItsLimits) {
  const SkfTorque radial = skf_torque(ball_bearing(), at(5000.0, 12.0, 500.0)),
                  traced = skf_torque(ball_bearing(), at(5000.0, 12.0, 500.0, 1e-6));
  EXPECT_NEAR(traced.rolling, radial.rolling, 1e-4 * radial.rolling);
  const SkfTorque creeping = skf_torque(roller_bearing(), at(1e-6, 12.0, 1100.0));
  EXPECT_NEAR(creeping.sliding, 1e-3 * 0.15 * 0.0015 * 33.5 * 1100.0, 1e-9);
}

// pi x 14 x 67 = 2946.8 mm^2 at 0.016 W/mm^2; beyond 50 000 mm^2 the density falls: 6340, 200 x 420 x 80 mm,
// 155 823 mm^2: 0.016 x 3.11646^-0.34 = 0.010871 W/mm^2.
TEST(ThermalReference, HeatByHand) {
  EXPECT_NEAR(thermal_reference::heat(roller_bearing()), 47.149, kByHand * 47.149);
  const BearingSize large{TorqueFamily::deep_groove, 200e-3, 420e-3, 80e-3, 465e3, 3, false};
  EXPECT_NEAR(thermal_reference::heat(large), 155823.0 * 0.016 * std::pow(3.11646, -0.34), 0.2);
}

// 7205: 25 x 52 mm, d_m 38.5 mm, under 500 N radial and 1000 N axial: Tables 3 and 3a of [SKF6000].
TEST(SkfTorque, OfAnAngularContactBearingByHand) {
  const BearingSize size{TorqueFamily::angular_contact, 25e-3, 52e-3, 15e-3, 10e3, 2, false};
  constexpr double d = 38.5, n = 5000.0, nu = 12.0;
  const SkfTorque torque = skf_torque(size, at(n, nu, 500.0, 1000.0));
  const double spin = std::pow(d, 4.0) * n * n;
  const double rolling =
      5.03e-7 * std::pow(d, 1.97) * std::pow(500.0 + 1.90e-12 * spin + 1.97 * 1000.0, 0.54);
  EXPECT_NEAR(torque.rolling,
              1e-3 * torque.inlet_heating * torque.starvation * rolling * std::pow(nu * n, 0.6), 1e-9);
  const double sliding = 1.30e-2 * std::pow(d, 0.26) *
                         (std::pow(500.0 + 1.91e-12 * spin, 4.0 / 3) + 0.68 * std::pow(1000.0, 4.0 / 3));
  const double mu = torque.boundary_share * 0.15 + (1.0 - torque.boundary_share) * 0.05;
  EXPECT_NEAR(torque.sliding, 1e-3 * mu * sliding, 1e-9);
}

}  // namespace
}  // namespace orbearing::bearing::friction::published_torque_test
