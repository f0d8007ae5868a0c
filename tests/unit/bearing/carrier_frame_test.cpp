#include "bearing/carrier_frame.hpp"
#include "mechanics/constants.hpp"

#include <gtest/gtest.h>


namespace orbearing::bearing::carrier_frame_test {
namespace {

using constants::half_pi;
using constants::pi;

constexpr double kRoundOff = 1e-13;  // sines and cosines of quarter turns, times values of order 10
constexpr InertiaSwitches kNone{
    .own_orbit = false, .coriolis = false, .carrier_centrifugal = false, .euler = false};

// Small whole numbers: Omega = 3, dOmega/dt = 5, r_c = 7; a roller at r = 2 with theta' = 11, r' = 13.
constexpr CarrierMotion kMotion{.speed = 3.0, .acceleration = 5.0, .orbit_radius = 7.0};

struct Polar {
  double radial;
  double tangential;
};

Polar roller(const InertiaSwitches& on, double theta) {
  const CarrierFrame frame = carrier_frame(kMotion, on);
  return {radial_inertial_acceleration(frame, 2.0, theta, 11.0),
          tangential_inertial_acceleration(frame, 2.0, theta, 13.0)};
}

void expect_polar(const Polar& actual, double radial, double tangential) {
  EXPECT_NEAR(actual.radial, radial, kRoundOff);
  EXPECT_NEAR(actual.tangential, tangential, kRoundOff);
}

TEST(CarrierFrame, NothingActsWithAllSwitchesOff) {
  expect_polar(roller(kNone, 1.0), 0.0, 0.0);
  EXPECT_EQ(inertial_acceleration(carrier_frame(kMotion, kNone), {2.0, 4.0}, {6.0, 8.0}).norm(), 0.0);
}

TEST(CarrierFrame, OwnOrbitAlone) {
  InertiaSwitches on = kNone;
  on.own_orbit = true;
  for (const double theta : {0.0, half_pi, pi}) expect_polar(roller(on, theta), 2.0 * 11.0 * 11.0, 0.0);
}

TEST(CarrierFrame, CoriolisAlone) {
  InertiaSwitches on = kNone;
  on.coriolis = true;
  for (const double theta : {0.0, half_pi, pi}) {
    expect_polar(roller(on, theta), 2.0 * 3.0 * 2.0 * 11.0, -2.0 * 3.0 * 13.0);
  }
  // Moving outward (x) in a frame that turns from x to y, a body is left behind, towards -y.
  const Eigen::Vector2d pushed = inertial_acceleration(carrier_frame(kMotion, on), {2.0, 4.0}, {6.0, 8.0});
  EXPECT_EQ(pushed, Eigen::Vector2d(2.0 * 3.0 * 8.0, -2.0 * 3.0 * 6.0));
}

TEST(CarrierFrame, CentrifugalAlone) {
  InertiaSwitches on = kNone;
  on.carrier_centrifugal = true;
  expect_polar(roller(on, 0.0), 9.0 * (2.0 + 7.0), 0.0);
  expect_polar(roller(on, half_pi), 9.0 * 2.0, -9.0 * 7.0);
  expect_polar(roller(on, pi), 9.0 * (2.0 - 7.0), 0.0);
  const Eigen::Vector2d thrown = inertial_acceleration(carrier_frame(kMotion, on), {2.0, 4.0}, {6.0, 8.0});
  EXPECT_EQ(thrown, Eigen::Vector2d(9.0 * (2.0 + 7.0), 9.0 * 4.0));
}

TEST(CarrierFrame, EulerAlone) {
  InertiaSwitches on = kNone;
  on.euler = true;
  expect_polar(roller(on, 0.0), 0.0, -5.0 * (2.0 + 7.0));
  expect_polar(roller(on, half_pi), -5.0 * 7.0, -5.0 * 2.0);
  expect_polar(roller(on, pi), 0.0, -5.0 * (2.0 - 7.0));
  // A carrier that speeds up leaves bodies behind: on the x axis towards -y.
  const Eigen::Vector2d lagging = inertial_acceleration(carrier_frame(kMotion, on), {2.0, 4.0}, {6.0, 8.0});
  EXPECT_EQ(lagging, Eigen::Vector2d(5.0 * 4.0, -5.0 * (2.0 + 7.0)));
}

TEST(CarrierFrame, SwitchesAddUpToTheWhole) {
  const Polar whole = roller(InertiaSwitches{}, 0.7);
  Polar sum{0.0, 0.0};
  for (const auto which : {&InertiaSwitches::own_orbit, &InertiaSwitches::coriolis,
                           &InertiaSwitches::carrier_centrifugal, &InertiaSwitches::euler}) {
    InertiaSwitches on = kNone;
    on.*which = true;
    sum.radial += roller(on, 0.7).radial;
    sum.tangential += roller(on, 0.7).tangential;
  }
  expect_polar(sum, whole.radial, whole.tangential);
}

}  // namespace
}  // namespace orbearing::bearing::carrier_frame_test
