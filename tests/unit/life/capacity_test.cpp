#include <gtest/gtest.h>

#include <cmath>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::bearing::rating::capacity_test {
namespace {

constexpr double kRoundOff = 1e-12;

RollerSet rollers() {
  return {.rollers = 15, .diameter = 5.24e-3, .length = 5.7e-3, .pitch_diameter = 36e-3};
}

BallSet balls() {
  return {.balls = 7, .diameter = 11.5e-3, .pitch_diameter = 43.5e-3};
}

TEST(RollerCapacity, GrowsWithRowsLengthRollersAndMaterial) {
  const double one = dynamic_capacity(rollers());
  RollerSet other = rollers();
  other.rows = 2;
  EXPECT_NEAR(dynamic_capacity(other) / one, std::pow(2.0, 7.0 / 9.0), kRoundOff);
  other = rollers();
  other.rollers *= 2;
  EXPECT_NEAR(dynamic_capacity(other) / one, std::pow(2.0, 0.75), kRoundOff);
  other = rollers();
  other.diameter *= 2.0;
  other.pitch_diameter *= 2.0;
  EXPECT_NEAR(dynamic_capacity(other) / one, std::pow(2.0, 29.0 / 27.0), kRoundOff);
  other = rollers();
  other.material_factor = 1.0;
  EXPECT_NEAR(dynamic_capacity(other) / one, 1.0 / 1.1, kRoundOff);
}

// Laminae find the uneven load themselves: the reduction factor of the rating must not be applied twice.
TEST(RollerCapacity, ContactsDoNotDependOnLambda) {
  RollerSet ideal = rollers();
  ideal.reduction_factor = 1.0;
  const ContactCapacities with = contact_capacities(rollers(), dynamic_capacity(rollers()));
  const ContactCapacities without = contact_capacities(ideal, dynamic_capacity(ideal));
  EXPECT_NEAR(with.inner / without.inner, 1.0, kRoundOff);
  EXPECT_NEAR(with.outer / without.outer, 1.0, kRoundOff);
}

// For gamma to 0 the races differ by their factors alone:
// Q_o/Q_i = 0.378/0.364 ((1 + 1.038^-4.5)/(1 + 1.038^4.5))^(2/9) = 0.378/(0.364 * 1.038).
TEST(RollerCapacity, RacesOfAVeryLargeBearingAreAlike) {
  RollerSet flat = rollers();
  flat.pitch_diameter = 1e15;
  const ContactCapacities contact = contact_capacities(flat, 1000.0);
  EXPECT_NEAR(contact.outer / contact.inner, 0.378 / 0.364 / 1.038, kRoundOff);
}

// n laminae with 1/n of the load each have the life of one: sum (q/q_c)^4.5 does not depend on n.
TEST(RollerCapacity, LaminaeTogetherAreTheRoller) {
  constexpr double capacity = 5000.0, load = 800.0;
  for (const int n : {1, 2, 40, 200}) {
    const double damage = n * std::pow(load / n / lamina_capacity(capacity, n), 4.5);
    EXPECT_NEAR(damage / std::pow(load / capacity, 4.5), 1.0, kRoundOff);
  }
}

// 44 (1 - gamma) Z l D in mm.
TEST(RollerCapacity, StaticByHand) {
  const double by_hand = 44.0 * (1.0 - 5.24 / 36.0) * 15.0 * 5.7 * 5.24;
  EXPECT_NEAR(static_capacity(rollers()) / by_hand, 1.0, kRoundOff);
}

TEST(BallCapacity, ContinuesAtTwentyFiveMillimetres) {
  constexpr double three_digits = 1e-3;  // 3.647 is 25.4^0.4 in four digits
  BallSet small = balls(), large = balls();
  small.diameter = 25.4e-3;
  large.diameter = 25.4001e-3;
  small.pitch_diameter = large.pitch_diameter = 0.1;
  EXPECT_NEAR(dynamic_capacity(large) / dynamic_capacity(small), 1.0, three_digits);
}

TEST(BallCapacity, WideGroovesTakeTheirOwnFactor) {
  BallSet wide = balls();
  wide.inner_osculation = 0.53;
  const double ratio = dynamic_capacity(wide) / dynamic_capacity(balls());
  EXPECT_NEAR(ratio, ball_capacity_factor(gamma(wide), 0.53, 0.53) / ball_capacity_factor(gamma(wide)),
              kRoundOff);
  EXPECT_LT(ratio, 0.95);
}

// A maker's C_0 of a bearing 6305, from memory, with seven balls of 11.5 mm is 11.6 kN; grooves differ
// between makers.
TEST(BallCapacity, StaticNearTheCatalogue) {
  constexpr double makers_differ = 0.05;
  EXPECT_NEAR(static_capacity(balls()) / 11.6e3, 1.0, makers_differ);
}

// At F_a/(Z D^2) = 1.03 the table gives e = 0.28, Y = 1.55.
TEST(DeepGroove, EquivalentLoadOnARowOfTheTable) {
  const double axial = 1.03 * 7.0 * 11.5 * 11.5;
  EXPECT_NEAR(deep_groove_equivalent_load(balls(), axial, axial), (0.56 + 1.55) * axial, axial * kRoundOff);
  EXPECT_EQ(deep_groove_equivalent_load(balls(), axial / 0.27, axial), axial / 0.27);
  EXPECT_EQ(deep_groove_equivalent_load(balls(), 500.0, 0.0), 500.0);
}

TEST(DeepGroove, EquivalentLoadIsContinuousBetweenRowsAndHeldAtTheEnds) {
  const double cell = 7.0 * 11.5 * 11.5;
  const double middle = 0.5 * (1.38 + 2.07) * cell;
  EXPECT_NEAR(deep_groove_equivalent_load(balls(), 0.0, middle), 0.5 * (1.45 + 1.31) * middle,
              middle * kRoundOff);
  EXPECT_NEAR(deep_groove_equivalent_load(balls(), 0.0, 100.0 * cell), 100.0 * cell,
              cell * kRoundOff * 100.0);
  EXPECT_NEAR(deep_groove_equivalent_load(balls(), 0.0, 0.01 * cell), 0.023 * cell, cell * kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::rating::capacity_test
