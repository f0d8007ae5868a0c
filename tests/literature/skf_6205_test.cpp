// Frequencies of the drive-end bearing SKF 6205 over that of the shaft, as published with the data sets of
// [CaseWestern].
#include <gtest/gtest.h>

#include "bearing/defect/frequencies.hpp"

namespace orbearing::bearing::defect::skf_6205_test {
namespace {

constexpr double kInch = 25.4e-3;  // [m]
constexpr double kPrinted =
    1e-4;  // relative: five digits, the cage's printed 0.39828 where the formula gives 0.39831

TEST(Skf6205, MultiplesOfTheShaftsFrequency) {
  Bearing bearing;
  bearing.elements = Balls{.count = 9, .diameter = 0.3126 * kInch};
  bearing.pitch_diameter = 1.537 * kInch;
  const PassingFrequencies found = passing_frequencies(bearing, 2.0 * 3.14159265358979324 * 29.95);
  const auto expect = [&](double frequency, double published) {
    EXPECT_NEAR(frequency / found.shaft, published, kPrinted * published);
  };
  expect(found.outer_pass, 3.5848);
  expect(found.inner_pass, 5.4152);
  expect(found.cage, 0.39828);
  expect(found.element_pass, 4.7135);
}

// [ScratchVibration], printed to one decimal.
TEST(ScratchVibration, KinematicFrequencies) {
  constexpr double printed = 0.05;  // [Hz]
  Bearing bearing;
  bearing.elements = Balls{.count = 8, .diameter = 11.509e-3};
  bearing.pitch_diameter = 48.5e-3;
  const PassingFrequencies found = passing_frequencies(bearing, 2.0 * 3.14159265358979324 * 25.0);
  EXPECT_NEAR(found.shaft, 25.0, 1e-12);
  EXPECT_NEAR(found.cage, 9.5, printed);
  EXPECT_NEAR(found.outer_pass, 76.3, printed);
  EXPECT_NEAR(found.inner_pass, 123.7, printed);
}

}  // namespace
}  // namespace orbearing::bearing::defect::skf_6205_test
