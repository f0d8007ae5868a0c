// Frequencies of the drive-end bearing SKF 6205 over that of the shaft, as published with the data sets of
// [CaseWestern].
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/defect/scratched_bearing.hpp"

namespace orbearing::bearing::defect::skf_6205_test {
namespace {

constexpr double kInch = 25.4e-3;  // [m]
constexpr double kPublished =
    1e-4;  // relative: five digits, the cage's printed 0.39828 where the formula gives 0.39831

constexpr double kAngle = 15.7 * 3.14159265358979324 / 180.0;  // of the ZA-2115

TEST(Skf6205, MultiplesOfTheShaftsFrequency) {
  Bearing bearing;
  bearing.elements = Balls{.count = 9, .diameter = 0.3126 * kInch};
  bearing.pitch_diameter = 1.537 * kInch;
  const PassingFrequencies found = passing_frequencies(bearing, 2.0 * 3.14159265358979324 * 29.95);
  const auto expect = [&](double frequency, double published) {
    EXPECT_NEAR(frequency / found.shaft, published, kPublished * published);
  };
  expect(found.outer_pass, 3.5848);
  expect(found.inner_pass, 5.4152);
  expect(found.cage, 0.39828);
  expect(found.element_pass, 4.7135);
}

// A ball under an angle turns about an axis across the line of its contacts: at both of them its surface has
// the race's speed, in the frame of the cage.
TEST(AngularContact, BallSurfaceKeepsUpWithBothRaces) {
  Bearing bearing;
  bearing.elements = Balls{.count = 16, .diameter = 8.4e-3, .contact_angle = kAngle};
  bearing.pitch_diameter = 71.5e-3;
  const double gamma = 8.4 / 71.5 * std::cos(kAngle), inner = 300.0, outer = -70.0;
  const double cage = 0.5 * (inner * (1.0 - gamma) + outer * (1.0 + gamma));
  const double surface = rolling_speed(bearing, inner, outer) * 4.2e-3;
  EXPECT_NEAR(surface, (outer - cage) * 35.75e-3 * (1.0 + gamma), 1e-12);
  EXPECT_NEAR(surface, (cage - inner) * 35.75e-3 * (1.0 - gamma), 1e-12);
}

// Rexnord ZA-2115 at 2000 rpm, the frequencies that programs of others print with the recordings of
// [QiuLeeLin2006].
TEST(Za2115, Frequencies) {
  Bearing bearing;
  bearing.elements = Balls{.count = 16, .diameter = 8.4e-3, .contact_angle = kAngle};
  bearing.pitch_diameter = 71.5e-3;
  const PassingFrequencies found = passing_frequencies(bearing, 2.0 * 3.14159265358979324 * 2000.0 / 60.0);
  EXPECT_NEAR(found.outer_pass, 236.4, 0.3);
  EXPECT_NEAR(found.inner_pass, 296.9, 0.3);
  EXPECT_NEAR(0.5 * found.element_pass, 139.9, 0.6);
}

// [ScratchVibration], printed to one decimal.
TEST(ScratchVibration, KinematicFrequencies) {
  constexpr double published = 0.05;  // [Hz]
  Bearing bearing;
  bearing.elements = Balls{.count = 8, .diameter = 11.509e-3};
  bearing.pitch_diameter = 48.5e-3;
  const PassingFrequencies found = passing_frequencies(bearing, 2.0 * 3.14159265358979324 * 25.0);
  EXPECT_NEAR(found.shaft, 25.0, 1e-12);
  EXPECT_NEAR(found.cage, 9.5, published);
  EXPECT_NEAR(found.outer_pass, 76.3, published);
  EXPECT_NEAR(found.inner_pass, 123.7, published);
}

}  // namespace
}  // namespace orbearing::bearing::defect::skf_6205_test
