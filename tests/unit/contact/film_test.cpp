#include "bearing/contact/race_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::film_test {
namespace {

constexpr double kRoundOff = 1e-12;        // a handful of powers in double precision, relative
constexpr double kDifferenceError = 1e-8;  // central difference with a step of 1e-5 of the load, relative

// Powers of ten make the film a hand calculation: 2.65 x 10^(-4.32 - 0.7 - 0.86 - 0.33) q^-0.13.
FilmContact powers_of_ten() {
  return {.equivalent_radius = 1e-2,
          .length = 1e-2,
          .reduced_modulus = 1e11,
          .lubricant = {.viscosity = 1e-2, .pressure_viscosity = 1e-8}};
}
constexpr double kSpeed = 10.0;  // [m/s]

TEST(Film, LeastFilmByHand) {
  const double load = 1e3;  // [N], 1e5 N/m over the length
  const double expected = 2.65 * std::pow(10.0, -6.86);
  EXPECT_NEAR(Film(powers_of_ten(), kSpeed).least(load), expected, expected * kRoundOff);
}

TEST(Film, CentralFilmIsFourThirdsOfTheLeast) {
  const Film film(powers_of_ten(), kSpeed);
  for (double load = 1e-6; load < 1e7; load *= 10.0) {
    EXPECT_NEAR(film.central(load), 4.0 / 3.0 * film.least(load), film.central(load) * kRoundOff);
  }
}

TEST(Film, GrowsWithSpeedToThePowerSevenTenths) {
  const double load = 1e4;
  const double ratio =
      Film(powers_of_ten(), 2.0 * kSpeed).least(load) / Film(powers_of_ten(), kSpeed).least(load);
  EXPECT_NEAR(ratio, std::pow(2.0, 0.7), kRoundOff);
}

TEST(Film, CapBeginsWhereTheRigidFilmCrosses) {
  const FilmContact contact = powers_of_ten();
  const Film film(contact, kSpeed);
  const double rigid = 4.896 * contact.lubricant.viscosity * kSpeed * contact.equivalent_radius /
                       (film.cap_load() / contact.length);
  EXPECT_NEAR(film.cap(), rigid, rigid * kRoundOff);
}

TEST(Film, IsContinuousAndConstantBelowTheCap) {
  const Film film(powers_of_ten(), kSpeed);
  ASSERT_GT(film.cap_load(), 0.0);
  const double above = film.cap_load() * (1.0 + 1e-12);
  EXPECT_NEAR(film.central(above), film.cap(), film.cap() * kRoundOff);
  EXPECT_NEAR(film.energy(above), 0.0, film.cap() * film.cap_load() * kRoundOff);
  for (const double fraction : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(film.central(fraction * film.cap_load()), film.cap());
    EXPECT_EQ(film.slope(fraction * film.cap_load()), 0.0);
    EXPECT_EQ(film.energy(fraction * film.cap_load()), 0.0);
  }
}

TEST(Film, SlopeIsTheDerivativeOfTheCentralFilm) {
  const Film film(powers_of_ten(), kSpeed);
  for (double load = 10.0 * film.cap_load(); load < 1e7; load *= 10.0) {
    const double step = 1e-5 * load;
    const double slope = (film.central(load + step) - film.central(load - step)) / (2.0 * step);
    EXPECT_NEAR(film.slope(load), slope, -slope * kDifferenceError);
  }
}

TEST(Film, NoSpeedNoViscosityOrNoFilmLeavesTheContactDry) {
  FilmContact thin = powers_of_ten();
  thin.lubricant.viscosity = 0.0;
  for (const Film& film : {Film(), Film(powers_of_ten(), 0.0), Film(thin, kSpeed)}) {
    for (const double load : {0.0, 1.0, 1e6}) {
      EXPECT_EQ(film.central(load), 0.0);
      EXPECT_EQ(film.slope(load), 0.0);
      EXPECT_EQ(film.energy(load), 0.0);
    }
    EXPECT_EQ(film.cap(), 0.0);
  }
}

TEST(FilmContact, TakesRadiusLengthAndReducedModulusFromTheBearing) {
  const Bearing bearing = example_bearings::planet_bearing();
  const FilmContact outer = film_contact(bearing, geometry_of(bearing), Race::outer, {.viscosity = 0.01});
  EXPECT_NEAR(outer.equivalent_radius, 2.62e-3 * 20.44e-3 / 17.82e-3, kRoundOff);
  EXPECT_EQ(outer.length, bearing.rollers().length);
  EXPECT_NEAR(outer.reduced_modulus, 206e9 / 0.91, 206e9 * kRoundOff);
  EXPECT_EQ(outer.lubricant.viscosity, 0.01);
}

}  // namespace
}  // namespace orbearing::bearing::film_test
