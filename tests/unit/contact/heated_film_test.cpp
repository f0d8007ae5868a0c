// Films that shear at the inlet makes thinner: [Gupta1992].
#include "bearing/contact/heated_film.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/geometry.hpp"
#include "bearing/motion/parameters.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::heated_film_test {
namespace {

constexpr double kRoundOff = 1e-12;

// By hand: 1/1.213; S = 1: 1/(1 + 0.213 3.23); p/E' = 0.005, L = 1: 1 - 0.066.
TEST(HeatedFilm, IsThePublishedShare) {
  EXPECT_EQ(heated_film_share(0.0, 0.005, 0.0), 1.0);
  EXPECT_NEAR(heated_film_share(1.0, 0.0, 0.0), 1.0 / 1.213, kRoundOff);
  EXPECT_NEAR(heated_film_share(1.0, 0.0, 1.0), 1.0 / (1.0 + 0.213 * 3.23), kRoundOff);
  EXPECT_NEAR(heated_film_share(1.0, 0.005, 0.0), 0.934 / 1.213, kRoundOff);
  EXPECT_NEAR(heated_film_share(10.0, 0.0, 0.5),
              1.0 / (1.0 + 0.213 * (1.0 + 2.23 * std::pow(0.5, 0.83)) * std::pow(10.0, 0.64)), kRoundOff);
  EXPECT_EQ(heated_film_share(1e6, 0.01, 0.0), 0.0);  // far beyond the formula
}

FilmContact contact_of(const Bearing& bearing) {
  return film_contact(bearing, geometry_of(bearing), Race::inner, {0.01, 1.5e-8});
}

motion::RaceContactParameters heated(double slope) {
  motion::RaceContactParameters race;
  race.film_heating = motion::FilmReduction::gupta;
  race.viscosity_slope = slope;
  return race;
}

TEST(HeatedFilm, IsIsothermalUnlessAskedForAndWithoutSpeed) {
  const FilmContact contact = contact_of(example_bearings::planet_bearing());
  const auto none = FilmHeating::of(motion::RaceContactParameters{}, contact.lubricant);
  EXPECT_EQ(none.share(contact, 1000.0, 20.0, 3.0), 1.0);
  const auto asked = FilmHeating::of(heated(0.03), contact.lubricant);
  EXPECT_EQ(asked.share(contact, 1000.0, 0.0), 1.0);
  EXPECT_LT(asked.share(contact, 1000.0, 20.0), 1.0);
  EXPECT_NEAR(FilmHeating::of(heated(1e-9), contact.lubricant).share(contact, 1000.0, 20.0), 1.0, 1e-4);
}

// Pressure of Hertz of a line: p = (Q E'/(2 pi R l))^(1/2), as E'/2 is the composite modulus of two bodies of
// E'.
TEST(HeatedFilm, HasThePressureOfHertz) {
  const FilmContact contact = contact_of(example_bearings::planet_bearing());
  const double load = 1500.0, speed = 12.0, loading = 0.03 * 0.01 * speed * speed / 0.14;
  const double half_width =
      std::sqrt(8.0 * load * contact.equivalent_radius / (M_PI * contact.reduced_modulus * contact.length));
  const double pressure = 2.0 * load / (M_PI * half_width * contact.length);
  const auto heating = FilmHeating::of(heated(0.03), contact.lubricant);
  EXPECT_NEAR(heating.share(contact, load, speed, -3.0),
              heated_film_share(loading, pressure / contact.reduced_modulus, 0.25), kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::heated_film_test
