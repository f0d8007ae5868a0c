// Ball on both races of a ball bearing, the worked example of [Hamrock2004], recomputed with exact elliptic
// integrals by independent programs.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/contact/point_contact.hpp"

namespace orbearing::bearing::hamrock_ball_contact_test {
namespace {

struct Row {
  Race race;
  double axis_ratio;  // [-]
  double deflection;  // [um]
  double pressure;    // [GPa]
  double diameter;    // [mm]  of the race
};

constexpr double kFourDigits = 2e-4;          // the numbers are given with four digits
constexpr double kLoad = 5.0 * 8900.0 / 9.0;  // [N]

TEST(HamrockBall, ContactsOfBothRaces) {
  constexpr double ball = 12.7e-3, groove = 6.604e-3;
  constexpr double pitch = 0.5 * (52.291e-3 + 77.706e-3);
  for (const Row& row :
       {Row{Race::inner, 9.285, 29.32, 3.112, 52.291}, Row{Race::outer, 7.295, 28.26, 2.600, 77.706}}) {
    SCOPED_TRACE(row.diameter);
    const PointContact contact =
        point_contact(ball_race_curvature(row.race, ball, pitch, groove, 0.0), {.youngs_modulus = 200e9});
    EXPECT_NEAR(contact.ellipse.axis_ratio / row.axis_ratio, 1.0, kFourDigits);
    EXPECT_NEAR(point_pressure(contact, kLoad).pressure * 1e-9 / row.pressure, 1.0, kFourDigits);
    EXPECT_NEAR(1e6 * std::pow(kLoad / contact.constant, 2.0 / 3.0) / row.deflection, 1.0, kFourDigits);
  }
}

TEST(HamrockBall, SemiAxesOnTheInnerRace) {
  constexpr double pitch = 0.5 * (52.291e-3 + 77.706e-3);
  const PointContact contact = point_contact(ball_race_curvature(Race::inner, 12.7e-3, pitch, 6.604e-3, 0.0),
                                             {.youngs_modulus = 200e9});
  EXPECT_NEAR(point_pressure(contact, kLoad).major * 1e3 / 2.654, 1.0, kFourDigits);
  EXPECT_NEAR(point_pressure(contact, kLoad).minor * 1e3 / 0.2858, 1.0, kFourDigits);
}

}  // namespace
}  // namespace orbearing::bearing::hamrock_ball_contact_test
