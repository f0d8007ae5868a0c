// Modes and frequency response of a shaft against closed forms.
#include "bearing/duplex/shaft.hpp"
#include "mechanics/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::bearing::duplex::shaft_test {
namespace {

constexpr double kPi = constants::pi;
constexpr double kRoundOff = 1e-12;

Stiffness uncoupled() {
  return Eigen::Vector<double, 5>(4e8, 5e8, 1e8, 3e4, 2e4).asDiagonal();
}

// x is coupled with the tilt in its plane, y with that in its own.
Stiffness coupled() {
  Stiffness k = uncoupled();
  k(0, 3) = k(3, 0) = -1.5e6;
  k(1, 4) = k(4, 1) = -1.1e6;
  return k;
}

const Shaft kShaft{.mass = 10.0, .levers = {0.03, 0.03}, .inertia_x = 0.02, .inertia_y = 0.03};

double hertz(double stiffness, double mass) {
  return std::sqrt(stiffness / mass) / (2.0 * kPi);
}

TEST(DuplexShaft, InertiaOfACylinder) {
  const double length = 0.15, diameter = 0.1, density = 7850.0;
  const double mass = density * 0.25 * kPi * diameter * diameter * length;
  EXPECT_NEAR(cylinder_inertia(mass, diameter, density), mass * (3.0 * 0.05 * 0.05 + length * length) / 12.0,
              kRoundOff);
}

TEST(DuplexShaft, GivesFiveModesInTheirOrder) {
  const PairModes modes = modes_of(uncoupled(), kShaft);
  const double expected[] = {hertz(2e4, 0.02), hertz(3e4, 0.03), hertz(1e8, 10.0), hertz(4e8, 10.0),
                             hertz(5e8, 10.0)};
  const char* names[] = {"tilt_x", "tilt_y", "axial_z", "radial_x", "radial_y"};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(modes[i].frequency, expected[i], kRoundOff * expected[i]);
    EXPECT_STREQ(name_of(modes[i].kind), names[i]);
  }
}

TEST(DuplexShaft, TiltAboutXMovesInThePlaneOfYUnlessAsPrinted) {
  EXPECT_GT(modes_of(coupled(), kShaft)[0].energy_share[4], 0.5);
  const PairModes published = modes_of(uncoupled(), kShaft, {}, TiltPlanes::literature_variant);
  EXPECT_NEAR(published[0].frequency, hertz(3e4, 0.02), kRoundOff * 1e3);
  EXPECT_NEAR(published[1].frequency, hertz(2e4, 0.03), kRoundOff * 1e3);
}

TEST(DuplexShaft, ModesSolveTheEquationOfMotionAndAreOrthogonal) {
  const Stiffness k = coupled();
  const Eigen::Vector<double, 5> masses(10.0, 10.0, 10.0, 0.03, 0.02);
  const PairModes modes = modes_of(k, kShaft);
  for (const PairMode& mode : modes) {
    const double squared = std::pow(2.0 * kPi * mode.frequency, 2);
    const Eigen::Vector<double, 5> inertia = squared * masses.cwiseProduct(mode.shape);
    EXPECT_LT((k * mode.shape - inertia).norm(), 1e-9 * inertia.norm());
    for (const PairMode& other : modes)
      EXPECT_NEAR(mode.shape.dot(masses.cwiseProduct(other.shape)), mode.kind == other.kind ? 1.0 : 0.0,
                  1e-9);
    EXPECT_NEAR(mode.energy_share.sum(), 1.0, 1e-12);
  }
}

// Alike in x and y, yet each mode stays in its plane.
TEST(DuplexShaft, EqualFrequenciesAreDistinguished) {
  Stiffness k = coupled();
  k(1, 1) = k(0, 0);
  k(4, 4) = k(3, 3);
  k(1, 4) = k(4, 1) = k(0, 3);
  k(0, 1) = k(1, 0) = 1e-3;  // round-off of 4e8
  Shaft shaft = kShaft;
  shaft.inertia_x = shaft.inertia_y;
  const PairModes modes = modes_of(k, shaft);
  EXPECT_EQ(modes[0].shape[0], 0.0);
  EXPECT_EQ(modes[3].shape[1], 0.0);
  EXPECT_NEAR(modes[0].frequency, modes[1].frequency, 1e-9 * modes[1].frequency);
}

TEST(DuplexShaft, AFreeHousingMovesAgainstTheShaft) {
  const Housing like{.mass = kShaft.mass, .inertia = 0.02};
  const PairModes alone = modes_of(uncoupled(), kShaft), both = modes_of(uncoupled(), kShaft, like);
  EXPECT_NEAR(both[2].frequency, std::sqrt(2.0) * alone[2].frequency, 1e-9);
  const PairModes heavy = modes_of(uncoupled(), kShaft, Housing{1e12, 1e12});
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(heavy[i].frequency, alone[i].frequency, 1e-6);
}

TEST(DuplexShaft, ResponseHasItsClosedLimits) {
  constexpr double eta = 0.005;
  const auto along_z = [&](const std::optional<Housing>& housing, double frequency) {
    return accelerance(uncoupled(), kShaft, housing, TiltPlanes::physical, {0.0, eta}, frequency)[2];
  };
  const double resonance = hertz(1e8, 10.0);
  EXPECT_NEAR(std::abs(along_z({}, resonance)), 1.0 / (eta * kShaft.mass), 1e-9);
  EXPECT_NEAR(std::abs(along_z({}, 1000.0 * resonance)), 1.0 / kShaft.mass, 1e-6);
  EXPECT_LT(std::abs(along_z({}, 1e-3 * resonance)), 1e-6);
  // Both bodies together where the force is slow.
  EXPECT_NEAR(std::abs(along_z(Housing{30.0, 0.1}, 1e-3 * resonance)), 1.0 / (10.0 + 30.0), 1e-6);
}

// Off the mass centre a force tilts the shaft too.
TEST(DuplexShaft, ResponseOffTheMassCentreShowsTheTilt) {
  const double tilt = hertz(3e4, 0.03), position = 0.06;
  const auto along_x = [&](double at) {
    return std::abs(accelerance(uncoupled(), kShaft, {}, TiltPlanes::physical, {at, 0.005}, tilt)[0]);
  };
  EXPECT_NEAR(along_x(position), position * position / (0.005 * 0.03), 0.02 * along_x(position));
  EXPECT_LT(along_x(0.0), 0.01);
}

}  // namespace
}  // namespace orbearing::bearing::duplex::shaft_test
