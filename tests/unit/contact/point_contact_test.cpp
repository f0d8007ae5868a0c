#include "bearing/contact/point_contact.hpp"
#include "mechanics/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace orbearing::bearing::point_contact_test {
namespace {

constexpr double kPi = constants::pi;
constexpr double kRoundOff = 1e-12;  // a few powers in double precision, relative

Material steel() {
  return {.youngs_modulus = 200e9, .poisson_ratio = 0.3};
}

// Q = 4/3 E* sqrt(R) delta^1.5 and p = (6 Q E*^2/(pi^3 R^2))^(1/3), E* = E/(2 (1 - nu^2)): [Johnson1985].
TEST(PointContact, SphereOnPlane) {
  constexpr double radius = 5e-3;  // [m]
  const PointContact contact = point_contact({.sum = 2.0 / radius, .difference = 0.0}, steel());
  const double effective = 200e9 / (2.0 * (1.0 - 0.09));
  const double constant = 4.0 / 3.0 * effective * std::sqrt(radius);
  EXPECT_NEAR(contact.constant, constant, constant * kRoundOff);
  const double load = 50.0;
  const PointPressure at_load = point_pressure(contact, load);
  const double pressure = std::cbrt(6.0 * load * effective * effective / (kPi * kPi * kPi * radius * radius));
  EXPECT_NEAR(at_load.pressure, pressure, pressure * kRoundOff);
  EXPECT_NEAR(at_load.major, std::cbrt(3.0 * load * radius / (4.0 * effective)), radius * kRoundOff);
  EXPECT_NEAR(load_at_pressure(contact, pressure), load, load * kRoundOff);
}

// The ellipse returns the difference from which it was found: F = ((r^2 + 1) E - 2 K)/((r^2 - 1) E).
TEST(PointContact, EllipseBelongsToTheDifference) {
  constexpr double solved = 1e-10;  // the equation is flat near the circle
  for (const double difference : {0.01, 0.3, 0.7, 0.95, 0.999, 0.99999}) {
    const ContactEllipse ellipse = contact_ellipse(difference);
    const double square = ellipse.axis_ratio * ellipse.axis_ratio;
    EXPECT_NEAR(((square + 1.0) * ellipse.second - 2.0 * ellipse.first) / ((square - 1.0) * ellipse.second),
                difference, solved);
  }
  EXPECT_EQ(contact_ellipse(0.0).axis_ratio, 1.0);
  for (const double impossible : {-0.1, 1.0, std::nan("")})
    EXPECT_THROW(contact_ellipse(impossible), std::invalid_argument);
}

TEST(PointContact, TwoAlikeInSeriesAreSofterByTwoToTheOneAndAHalf) {
  const PointContact contact = point_contact({.sum = 300.0, .difference = 0.9}, steel());
  EXPECT_NEAR(in_series(contact, contact), contact.constant / std::pow(2.0, 1.5),
              contact.constant * kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::point_contact_test
