// Pair of 62 teeth each, m = 2 mm, 20 mm wide, 35 mm bore: numbers of independent scripts and a public code.
#include <gtest/gtest.h>

#include <algorithm>

#include "gearset/mesh/iso6336.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::mesh_62_62_test {
namespace {

constexpr double stated_parts = 0.01;
constexpr double stated_whole = 0.03;

void expect_stiffness(double compliance, double published, double tolerance) {
  EXPECT_NEAR(1.0 / compliance, published, tolerance * published);
}

TEST(SpurPair62, ContactRatioOfItsMesh) {
  EXPECT_NEAR(mesh_stiffness(meshing(example_pair(62, 62))).contact_ratio, 1.7897798668, 1e-6);
}

// The published parts are those of one tooth; both gears are equal.
TEST(SpurPair62, PartsAtThePitchPoint) {
  const PairCompliance pair = mesh_stiffness(meshing(example_pair(62, 62))).at_pitch_point;
  expect_stiffness(pair.hertz, 3.5558686e9, 1e-3);
  for (const GearCompliance& gear : {pair.first, pair.second}) {
    expect_stiffness(gear.tooth.bending, 1.150e10, stated_parts);
    expect_stiffness(gear.tooth.shear, 2.238e9, stated_parts);
    expect_stiffness(gear.tooth.axial, 6.202e10, stated_parts);
    expect_stiffness(gear.foundation, 7.196e8, stated_whole);
  }
}

TEST(SpurPair62, RootAngleIsTheTrochoids) {
  constexpr double half_digit = 0.5e-5;  // [rad]
  EXPECT_NEAR(meshing(example_pair(62, 62)).second.body.half_angle, 0.04859, half_digit);
}

TEST(SpurPair62, StiffnessOverThePeriod) {
  const MeshStiffness mesh = mesh_stiffness(meshing(example_pair(62, 62)));
  std::vector<double> single, twofold;
  for (int i = 0; i < 1000; ++i) {
    const double fraction = (i + 0.5) / 1000.0;
    (fraction < mesh.contact_ratio - 1.0 ? twofold : single).push_back(mesh.curve.value(fraction));
  }
  const auto expect_range = [](const std::vector<double>& values, double least, double largest) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_NEAR(*low, least, stated_whole * least);
    EXPECT_NEAR(*high, largest, stated_whole * largest);
  };
  expect_range(single, 2.394e8, 2.404e8);
  expect_range(twofold, 4.156e8, 4.380e8);
  EXPECT_NEAR(mesh.curve.mean(), 3.903e8, stated_whole * 3.903e8);
}

// Coefficients that a script recomputed from the polynomials, to the digits stated.
TEST(Sainsot2004, Coefficients) {
  const FoundationCoefficients c = sainsot_coefficients(0.0456584787, 3.4);
  constexpr double half_digit = 0.5e-5;
  EXPECT_NEAR(c.moment, 6.93414, half_digit);
  EXPECT_NEAR(c.cross, 1.23528, half_digit);
  EXPECT_NEAR(c.shear, 4.97563, half_digit);
  EXPECT_NEAR(c.compression, 0.40621, half_digit);
}

Iso6336Stiffness standard(int first, int second) {
  const double ratio = pair_geometry(example_pair(first, second)).contact_ratio;
  return iso6336_stiffness({first, second, 0.0, 0.0, {}, ratio, {}});
}

TEST(Iso6336MethodB, OfTwoPairs) {
  constexpr double unit = 1e9;  // [Pa] N/(mm um)
  constexpr double half_digit = 0.5e-3 * unit;
  EXPECT_NEAR(standard(62, 62).theoretical_single, 18.554 * unit, half_digit);
  EXPECT_NEAR(standard(62, 62).single, 14.472 * unit, half_digit);
  EXPECT_NEAR(standard(62, 62).mesh, 23.04 * unit, 10.0 * half_digit);
  EXPECT_NEAR(standard(30, 20).theoretical_single, 15.723 * unit, half_digit);
  EXPECT_NEAR(standard(30, 20).single, 12.264 * unit, half_digit);
  EXPECT_NEAR(standard(30, 20).mesh, 17.830 * unit, half_digit);
}

}  // namespace
}  // namespace orbearing::gearset::mesh_62_62_test
