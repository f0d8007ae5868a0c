#include "bearing/default_design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbearing::bearing::usual_design_test {
namespace {

constexpr double kRoundOff = 1e-12;

constexpr PlanetPin pin{
    .diameter = 25e-3, .loaded_length = 28e-3, .span = 35e-3, .youngs_modulus = 206e9, .poisson_ratio = 0.3};
constexpr CageBar bar{.length = 6e-3, .height = 2.5e-3, .thickness = 2e-3, .youngs_modulus = 6e9};

double bending_stiffness(const PlanetPin& p) {
  return p.youngs_modulus * std::numbers::pi * std::pow(p.diameter, 4) / 64.0;
}

double shear_stiffness(const PlanetPin& p) {
  const double area = std::numbers::pi * p.diameter * p.diameter / 4.0;
  return p.youngs_modulus / (2.0 * (1.0 + p.poisson_ratio)) * area * 6.0 * (1.0 + p.poisson_ratio) /
         (7.0 + 6.0 * p.poisson_ratio);
}

// Mean deflection by the energy of bending moment and shear force, summed over the span.
double mean_deflection(const PlanetPin& p) {
  const double bending = bending_stiffness(p), shear = shear_stiffness(p);
  constexpr int slices = 20000;
  double sum = 0.0;
  for (int i = 0; i < slices; ++i) {
    const double x = (i + 0.5) * p.span / slices, from = 0.5 * (p.span - p.loaded_length);
    const double loaded = std::clamp(x - from, 0.0, p.loaded_length);  // [m] left of x
    const double force = 0.5 - loaded / p.loaded_length;
    const double moment =
        0.5 * x - 0.5 * loaded * loaded / p.loaded_length - std::max(0.0, x - from - p.loaded_length);
    sum += (moment * moment / bending + force * force / shear) * p.span / slices;
  }
  return sum;
}

TEST(PinStiffness, IsThatOfTheBeamsEnergy) {
  constexpr double midpoint_rule = 1e-6;
  EXPECT_NEAR(pin_stiffness(pin) * mean_deflection(pin), 1.0, midpoint_rule);
  PlanetPin bare = pin;
  bare.span = bare.loaded_length;
  EXPECT_NEAR(pin_stiffness(bare) * mean_deflection(bare), 1.0, midpoint_rule);
}

// A slender beam that is loaded all over: delta/F = S^3/(120 E I).
TEST(PinStiffness, OfASlenderPinIsBendingAlone) {
  PlanetPin slender = pin;
  slender.span = slender.loaded_length = 100.0 * slender.diameter;
  const double second_moment = std::numbers::pi * std::pow(slender.diameter, 4) / 64.0;
  constexpr double shear_left_out = 1e-3;  // of order (d/S)^2
  EXPECT_NEAR(pin_stiffness(slender) * std::pow(slender.span, 3) / (120.0 * 206e9 * second_moment), 1.0,
              shear_left_out);
}

// Clamped at one end, by the energy of what lies beyond each section.
TEST(PinStiffness, HeldAtOneEndIsThatOfTheBeamsEnergy) {
  constexpr double midpoint_rule = 1e-6;
  for (const double span : {35e-3, 28e-3}) {
    PlanetPin held = pin;
    held.ends = PinEnds::one;
    held.span = span;
    const double from = 0.5 * (span - held.loaded_length), to = from + held.loaded_length;
    constexpr int slices = 20000;
    double sum = 0.0;
    for (int i = 0; i < slices; ++i) {
      const double x = (i + 0.5) * to / slices;
      const double force = std::clamp((to - x) / held.loaded_length, 0.0, 1.0);
      const double moment = force * (0.5 * (std::max(from, x) + to) - x);
      sum +=
          (moment * moment / bending_stiffness(held) + force * force / shear_stiffness(held)) * to / slices;
    }
    EXPECT_NEAR(pin_stiffness(held) * sum, 1.0, midpoint_rule);
  }
}

// A quarter of the cantilever's bending under a force at its end, L^3/(12 E I), and the shear of its length.
TEST(PinStiffness, OfAFlexpinIsThatOfAGuidedCantilever) {
  PlanetPin flexpin = pin;
  flexpin.ends = PinEnds::flexpin;
  const double by_hand = std::pow(flexpin.span, 3) / (12.0 * bending_stiffness(flexpin)) +
                         flexpin.span / shear_stiffness(flexpin);
  EXPECT_NEAR(pin_stiffness(flexpin) * by_hand, 1.0, kRoundOff);
  EXPECT_NEAR(pin_stiffness(flexpin) * pin_compliance({.diameter = pin.diameter,
                                                       .span = pin.span,
                                                       .ends = PinEnds::flexpin,
                                                       .material = {206e9, 0.3}},
                                                      {0.0})(0, 0),
              1.0, 1e-8);
}

// Bending and shear both scale with the size at constant shape.
TEST(DefaultDesign, StiffnessScalesWithSizeAndModulus) {
  for (const double factor : {0.1, 10.0}) {
    PlanetPin larger = pin;
    larger.diameter *= factor;
    larger.loaded_length *= factor;
    larger.span *= factor;
    EXPECT_NEAR(pin_stiffness(larger), factor * pin_stiffness(pin), kRoundOff * factor * pin_stiffness(pin));
    CageBar thicker = bar;
    thicker.length *= factor;
    thicker.height *= factor;
    thicker.thickness *= factor;
    thicker.youngs_modulus *= 3.0;
    EXPECT_NEAR(cage_bar_stiffness(thicker), 3.0 * factor * cage_bar_stiffness(bar),
                3.0 * kRoundOff * factor * cage_bar_stiffness(bar));
    EXPECT_NEAR(default_pocket_clearance(factor * 5e-3, factor * 36e-3, 15),
                factor * default_pocket_clearance(5e-3, 36e-3, 15), kRoundOff);
  }
}

// Clamped at both ends under a spread load: F l^3/(720 E I) in the mean.
TEST(CageBarStiffness, OfASlenderBarIsBendingAlone) {
  CageBar slender = bar;
  slender.length = 200.0 * slender.thickness;
  const double second_moment = bar.height * std::pow(bar.thickness, 3) / 12.0;
  constexpr double shear_left_out = 1e-2;  // 15.6 (t/l)^2 (1 + nu)
  EXPECT_NEAR(cage_bar_stiffness(slender) * std::pow(slender.length, 3) / (720.0 * 6e9 * second_moment), 1.0,
              shear_left_out);
}

TEST(DefaultCageMaterial, IsTheNearestInDensity) {
  EXPECT_EQ(default_cage_material(1310.0).name, "glass-filled polyamide");
  EXPECT_EQ(default_cage_material(1450.0).name, "glass-filled polyamide");
  EXPECT_EQ(default_cage_material(7800.0).name, "steel");
  EXPECT_EQ(default_cage_material(8700.0).name, "brass");
  EXPECT_EQ(default_cage_material(8700.0).youngs_modulus, 105e9);
}

TEST(DefaultPocketClearance, LeavesRoomForBars) {
  EXPECT_NEAR(default_pocket_clearance(5e-3, 36e-3, 15), 0.1e-3, kRoundOff);
  const double spacing = 36e-3 * std::sin(std::numbers::pi / 15);
  const double tight = spacing - 0.05e-3;
  EXPECT_NEAR(default_pocket_clearance(tight, 36e-3, 15), 0.025e-3, kRoundOff);
  EXPECT_EQ(default_pocket_clearance(1.1 * spacing, 36e-3, 15), 0.0);
  EXPECT_NEAR(cage_bar_thickness(tight, 0.025e-3, 36e-3, 15), 0.025e-3, kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::usual_design_test
