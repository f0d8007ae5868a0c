// Ball on both races of a ball bearing, the worked example of [Hamrock2004], recomputed with exact elliptic
// integrals by independent programs.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/contact/point_contact.hpp"
#include "bearing/contact/point_film.hpp"

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

TEST(HamrockBall, FilmsOfBothRaces) {
  constexpr double ball = 12.7e-3, inner = 52.291e-3, outer = 77.706e-3, speed = 400.0;
  constexpr double pitch = 0.5 * (inner + outer), half_per_cent = 5e-3;
  struct Film {
    Race race;
    double diameter, least, central;  // [m], [um], [um]
  };
  // Half the sum of the surface speeds where the cage rotates with half the inner race's centre speed.
  const double surface = 0.25 * speed * (pitch * pitch - ball * ball) / pitch;
  for (const Film& row : {Film{Race::inner, inner, 0.5527, 0.6904}, Film{Race::outer, outer, 0.661, 0.828}}) {
    const PointContact contact =
        point_contact(ball_race_curvature(row.race, ball, pitch, 6.604e-3, 0.0), {.youngs_modulus = 200e9});
    const double side = row.race == Race::inner ? 1.0 : -1.0;
    const OiledPoint oil{.viscosity = 0.04,
                         .pressure_viscosity = 2.3e-8,
                         .rolling_radius = 1.0 / (2.0 / ball + side * 2.0 / row.diameter),
                         .axis_ratio = contact.ellipse.axis_ratio,
                         .modulus = contact.modulus};
    const auto film = [&](const PointFilmLaw& law) {
      return 1e6 * std::exp(law.log_film(std::log(kLoad), std::log(surface)));
    };
    EXPECT_NEAR(film(PointFilmLaw::least(oil)) / row.least, 1.0, half_per_cent);
    EXPECT_NEAR(film(PointFilmLaw::central(oil)) / row.central, 1.0, half_per_cent);
  }
}

}  // namespace
}  // namespace orbearing::bearing::hamrock_ball_contact_test
