// Elliptical contacts drawn at random, RANDOM_FILMS of them, which no other test uses: each film is solved,
// and its oil conserved, or reported as not solved after at most 60 cycles on the finest grid.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "bearing/film/reynolds/point.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::film::reynolds_random_test {
namespace {

TEST(RandomFilms, AreSolvedOrReportedWithinTheirCycles) {
  const char* stated = std::getenv("RANDOM_FILMS");
  const int contacts = stated ? std::atoi(stated) : 5;
  std::mt19937_64 engine(20261123);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine);
  };
  const auto decades = [&](double least, double most) {
    return std::pow(10.0, between(std::log10(least), std::log10(most)));
  };
  int solved = 0;
  for (int i = 0; i < contacts; ++i) {
    constexpr double kRadius = 0.008, kModulus = 226e9;  // [m], [Pa]
    PointFilmCase contact{.modulus = kModulus};
    contact.oil = {.viscosity = decades(0.004, 0.2), .pressure_viscosity = between(8e-9, 24e-9)};
    const double ellipticity = decades(1.0, 10.0);
    set_ellipse(contact, kRadius, ellipticity);
    const double load = decades(1e-7, 3e-6), speed = decades(1e-12, 5e-11);  // W and U of the formulas
    contact.load = load * kModulus * kRadius * kRadius;
    contact.rolling = speed * kModulus * kRadius / contact.oil.viscosity;
    contact.angle = between(0.0, 0.5 * constants::pi);
    contact.spin = between(0.0, 0.3) * contact.rolling / 1e-3;
    const PointFilm film = solve_point_film(contact);
    EXPECT_LE(film.cycles, 60) << i;
    if (!film.converged) {
      std::cout << i << ": not solved, k = " << ellipticity << ", U = " << speed << ", W = " << load << ", "
                << contact.angle << " rad, spin " << contact.spin * 1e-3 / contact.rolling << ", "
                << film.cycles << " cycles\n";
      continue;
    }
    ++solved;
    EXPECT_LT(film.load_error, 1e-5) << i;
    EXPECT_LT(film.mass_error, 1e-3) << i;
    EXPECT_GT(film.least, 0.0) << i;
    EXPECT_GE(film.central, film.least) << i;
  }
  std::cout << solved << " of " << contacts << " solved\n";
}

}  // namespace
}  // namespace orbearing::bearing::film::reynolds_random_test
