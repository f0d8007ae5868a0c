// Ratings of tapered and spherical roller bearings by ISO 281 and ISO 76, with the formulas once more by
// hand.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/life/inclined_rating.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::rating::inclined_rating_test {
namespace {

using constants::degree;

constexpr double kRoundOff = 1e-12;

Bearing rollers(int count, double diameter, double length, double pitch) {
  Bearing bearing;
  bearing.elements = CylindricalRollers{.count = count, .diameter = diameter, .length = length};
  bearing.pitch_diameter = pitch;
  return bearing;
}

PlanetRows rows_of(PlanetBearingType type, double degrees) {
  return {.type = type, .contact_angle = degrees * degree};
}

// f_c, then b_m f_c (i l cos(alpha))^(7/9) Z^(3/4) D^(29/27), N and mm.
double by_hand(double factor, double rows, double count, double diameter, double length, double pitch,
               double angle) {
  const double gamma = diameter * std::cos(angle) / pitch;
  const double ratio = 1.04 * std::pow((1 - gamma) / (1 + gamma), 143.0 / 108.0);
  const double f_c = 0.377 * 551.13373 * 0.83 * std::pow(gamma, 2.0 / 9.0) *
                     std::pow(1 - gamma, 29.0 / 27.0) / std::pow(1 + gamma, 0.25) *
                     std::pow(1 + std::pow(ratio, 4.5), -2.0 / 9.0);
  return factor * f_c * std::pow(rows * length * std::cos(angle), 7.0 / 9.0) * std::pow(count, 0.75) *
         std::pow(diameter, 29.0 / 27.0);
}

TEST(InclinedRating, CapacitiesAreThoseOfTheFormula) {
  const Bearing tapered = rollers(19, 34e-3, 58e-3, 225e-3), spherical = rollers(14, 25e-3, 20e-3, 135e-3);
  const BearingRating one = planet_bearing_rating(tapered, rows_of(PlanetBearingType::tapered_roller, 16.0));
  EXPECT_NEAR(one.ratings.dynamic_capacity / by_hand(1.1, 1, 19, 34, 58, 225, 16 * degree), 1.0, kRoundOff);
  EXPECT_NEAR(one.ratings.static_capacity /
                  (44 * (1 - 34 * std::cos(16 * degree) / 225) * 19 * 58 * 34 * std::cos(16 * degree)),
              1.0, kRoundOff);
  EXPECT_EQ(one.elements, 19);
  const BearingRating two =
      planet_bearing_rating(spherical, rows_of(PlanetBearingType::spherical_roller, 12.0));
  EXPECT_NEAR(two.ratings.dynamic_capacity / by_hand(1.15, 2, 14, 25, 20, 135, 12 * degree), 1.0, kRoundOff);
  EXPECT_NEAR(two.ratings.static_capacity /
                  (44 * (1 - 25 * std::cos(12 * degree) / 135) * 2 * 14 * 20 * 25 * std::cos(12 * degree)),
              1.0, kRoundOff);
  EXPECT_EQ(two.elements, 28);
}

TEST(InclinedRating, StatedCapacitiesTakeTheirPlace) {
  const BearingRating stated = planet_bearing_rating(rollers(19, 34e-3, 58e-3, 225e-3),
                                                     rows_of(PlanetBearingType::tapered_roller, 16.0),
                                                     {.dynamic_capacity = 1e6, .static_capacity = 2e6});
  EXPECT_EQ(stated.ratings.dynamic_capacity, 1e6);
  EXPECT_EQ(stated.ratings.static_capacity, 2e6);
}

// e = 1.5 tan(alpha); one row (0.4, 0.4 cot), two rows (1, 0.45 cot) and (0.67, 0.67 cot).
TEST(InclinedRating, EquivalentLoads) {
  const double tangent = std::tan(15.0 * degree), e = 1.5 * tangent;
  const RollerSet one{.rows = 1, .contact_angle = 15.0 * degree},
      two{.rows = 2, .contact_angle = 15.0 * degree};
  EXPECT_EQ(inclined_equivalent_load(one, 1000.0, 0.99 * e * 1000.0), 1000.0);
  EXPECT_NEAR(inclined_equivalent_load(one, 1000.0, 800.0), 400.0 + 0.4 / tangent * 800.0, 1e-9);
  EXPECT_NEAR(inclined_equivalent_load(two, 1000.0, 100.0), 1000.0 + 0.45 / tangent * 100.0, 1e-9);
  EXPECT_NEAR(inclined_equivalent_load(two, 1000.0, 800.0), 670.0 + 0.67 / tangent * 800.0, 1e-9);
  // The factors of one row meet at e to the digits of the table.
  EXPECT_NEAR(inclined_equivalent_load(one, 1000.0, 1.000001 * e * 1000.0), 1000.0, 1e-2);
  EXPECT_EQ(inclined_static_load(one, 1000.0, 100.0), 1000.0);
  EXPECT_NEAR(inclined_static_load(one, 1000.0, 3000.0), 500.0 + 0.22 / tangent * 3000.0, 1e-9);
  EXPECT_NEAR(inclined_static_load(two, 1000.0, 300.0), 1000.0 + 0.44 / tangent * 300.0, 1e-9);
}

// Q_c with gamma = D cos(alpha)/d_m and (D/d_m)^(2/9).
TEST(InclinedRating, ContactCapacitiesOfLundbergAndPalmgren) {
  const Bearing bearing = rollers(19, 34e-3, 58e-3, 225e-3);
  const ContactCapacities found =
      planet_contact_capacities(bearing, rows_of(PlanetBearingType::tapered_roller, 16.0), 0.83);
  const double gamma = 34 * std::cos(16 * degree) / 225;
  const auto by_hand_of = [&](double side) {
    return 552 * 0.83 * std::pow(1 + side * gamma, 29.0 / 27.0) / std::pow(1 - side * gamma, 0.25) *
           std::pow(34.0 / 225.0, 2.0 / 9.0) * std::pow(34.0, 29.0 / 27.0) * std::pow(58.0, 7.0 / 9.0) *
           std::pow(19.0, -0.25);
  };
  EXPECT_NEAR(found.inner / by_hand_of(-1), 1.0, kRoundOff);
  EXPECT_NEAR(found.outer / by_hand_of(1), 1.0, kRoundOff);
  const ContactCapacities level = planet_contact_capacities(bearing, {}, 0.83);
  EXPECT_EQ(level.inner, contact_capacity(bearing, Race::inner, 0.83));
}

}  // namespace
}  // namespace orbearing::bearing::rating::inclined_rating_test
