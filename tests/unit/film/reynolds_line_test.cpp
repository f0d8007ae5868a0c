// Reynolds' equation of a line contact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bearing/contact/friction.hpp"
#include "bearing/contact/race_contact.hpp"
#include "bearing/film/reynolds/line.hpp"

namespace orbearing::bearing::film::reynolds_line_test {
namespace {

constexpr double radius = 0.01, modulus = 2.28e11;

// In the groups of [DowsonHigginson1966]: U = eta u/(E' R), W = q/(E' R).
LineFilmCase of_groups(double speed, double load) {
  const ReynoldsOil oil{.viscosity = 0.02, .pressure_viscosity = 2e-8};
  return {.radius = radius,
          .modulus = modulus,
          .oil = oil,
          .load = load * modulus * radius,
          .rolling = speed * modulus * radius / oil.viscosity};
}

TEST(ReynoldsLine, LoadBalancesAndMassIsKept) {
  for (const double load : {1e-6, 1e-5, 1e-4}) {
    const LineFilm film = solve_line_film(of_groups(1e-11, load));
    ASSERT_TRUE(film.converged) << load;
    EXPECT_LT(film.load_error, 1e-5);
    EXPECT_LT(film.mass_error, 1e-9);
    const double step = film.x[1] - film.x[0];
    EXPECT_NEAR(film.pressure.sum() * step / (load * modulus * radius), 1.0, 1e-9);
    // Beyond its edge the film carries the same oil in a part of the gap.
    const Eigen::Index n = film.x.size() - 1;
    EXPECT_LT(film.fraction[n], 1.0);
    EXPECT_NEAR(film.fraction[n] * film.film[n] / (film.fraction[n - 5] * film.film[n - 5]), 1.0, 1e-12);
  }
}

// Rigid cylinders and oil of one viscosity: least film 4.896 U/W R [Martin1916], with the domain's end taken
// out by two domains: what lies beyond an inlet of gap h costs in proportion to (h/h_0)^-3/2.
TEST(ReynoldsLine, MartinsFilmOfRigidCylinders) {
  LineFilmCase rigid = of_groups(1e-11, 1e-7);
  rigid.oil.pressure_viscosity = 0.0;
  rigid.oil.compressible = false;
  rigid.modulus *= 1e4;  // stiff, at the same load and speed
  const double martin = 4.896 * 1e-11 / 1e-7 * radius;
  const double half_width = std::sqrt(8.0 * rigid.load * radius / (std::numbers::pi * rigid.modulus));
  const double unit = std::sqrt(2.0 * radius * martin) / half_width;
  const LineFilm film = solve_line_film(rigid, {.cells = 1200, .inlet = 24.0 * unit, .outlet = 2.0 * unit});
  ASSERT_TRUE(film.converged);
  EXPECT_NEAR(film.least / martin, 1.0, 5e-3);
}

TEST(ReynoldsLine, HertzsContactIsTheLimit) {
  const LineFilm film = solve_line_film(of_groups(1e-13, 1e-4), {.cells = 1200, .inlet = 2.5, .outlet = 1.3});
  ASSERT_TRUE(film.converged);
  const double hertz = modulus * std::sqrt(8.0 * 1e-4 / std::numbers::pi) / 4.0;
  EXPECT_NEAR(film.pressure[static_cast<Eigen::Index>(std::lround(2.5 / 3.8 * 1200))] / hertz, 1.0, 0.01);
}

TEST(ReynoldsLine, FilmsAreOfSecondOrder) {
  for (const double shift : {0.0, 0.37}) {
    double central[3], least[3];
    for (int level = 0; level < 3; ++level) {
      const LineFilm film = solve_line_film(
          of_groups(1e-11, 3e-5),
          {.cells = 192 << level, .inlet = 4.0, .outlet = 1.5, .shift = shift * (1 << level)});
      ASSERT_TRUE(film.converged);
      central[level] = film.central;
      least[level] = film.least;
    }
    for (const double* f : {central, least}) {
      const double ratio = (f[1] - f[0]) / (f[2] - f[1]);
      EXPECT_GT(ratio, 3.0) << shift;
      EXPECT_LT(ratio, 5.5) << shift;
    }
  }
}

// The rolling traction is the first moment of the pressure: small compared with the load, and sensitive where
// pressure has its spike. In oils without one, order 2; with it the order is 1.4, and the error of the
// default grid below 1 %.
TEST(ReynoldsLine, RollingTractionIsOfSecondOrder) {
  struct {
    double material, speed, load;
  } const lines[]{{1e3, 1e-10, 1e-5}, {1e3, 1e-11, 3e-5}, {1e3, 1e-10, 1e-4}};
  for (const auto& one : lines) {
    LineFilmCase line = of_groups(one.speed, one.load);
    line.oil.pressure_viscosity = one.material / modulus;
    double traction[3];
    for (int level = 0; level < 3; ++level) {
      const LineFilm film = solve_line_film(line, {.cells = 192 << level});
      ASSERT_TRUE(film.converged);
      traction[level] = film.rolling_traction;
    }
    const double order = std::log2((traction[1] - traction[0]) / (traction[2] - traction[1]));
    EXPECT_NEAR(order, 2.0, 0.15) << one.speed << ' ' << one.load;
  }
  const LineFilmCase spiked = of_groups(1e-11, 1e-4);
  EXPECT_NEAR(
      solve_line_film(spiked).rolling_traction / solve_line_film(spiked, {.cells = 768}).rolling_traction,
      1.0, 0.01);
}

TEST(ReynoldsLine, TheFlowIsTheOilThatLeaves) {
  const LineFilm film = solve_line_film(of_groups(1e-11, 3e-5));
  const Eigen::Index last = film.x.size() - 1;
  EXPECT_NEAR(film.flow / (film.fraction[last] * film.film[last]), 1.0, 1e-9);
  EXPECT_LT(film.flow, 1.3 * film.central);
  EXPECT_GT(film.flow, film.central);  // denser there
}

// Twice the domain: what it lacks of the rolling traction is what a parabola adds.
TEST(ReynoldsLine, TheInletBeyondTheDomainIsAccountedFor) {
  const LineFilm film = solve_line_film(of_groups(1e-10, 3e-5), {.cells = 384, .inlet = 5.0, .outlet = 1.5});
  const LineFilm longer =
      solve_line_film(of_groups(1e-10, 3e-5), {.cells = 678, .inlet = 10.0, .outlet = 1.475});
  const double all = film.rolling_traction + film.inlet_beyond;
  EXPECT_GT(film.inlet_beyond, 0.05 * all);
  EXPECT_NEAR((longer.rolling_traction + longer.inlet_beyond) / all, 1.0, 0.02);
}

// The rolling resistance of rollers in motion is that of Reynolds' equation, at points that took part in the
// interpolation and at others between and beyond them; order 1.5 where pressure has its spike.
TEST(ReynoldsLine, RollersInMotionFeelTheRollingResistanceThatIsComputed) {
  for (const double material : {3e3, 5.2e3})
    for (const double speed : {1e-12, 3e-10})
      for (const double load : {2e-7, 1.7e-5, 3e-4}) {
        LineFilmCase line = of_groups(speed, load);
        line.oil.pressure_viscosity = material / modulus;
        const auto on_cells = [&](int cells) {
          const LineFilm film = solve_line_film(line, {.cells = cells});
          EXPECT_TRUE(film.converged);
          return film.rolling_traction + film.inlet_beyond;
        };
        const double coarse = on_cells(384), fine = on_cells(768);
        const double resistance = fine + (fine - coarse) / (std::pow(2.0, 1.5) - 1.0);
        const FilmContact contact{.equivalent_radius = radius,
                                  .length = 1.0,
                                  .reduced_modulus = modulus,
                                  .lubricant = {.viscosity = line.oil.viscosity,
                                                .pressure_viscosity = line.oil.pressure_viscosity}};
        const auto oiled = oiled_contact(line.load, std::log(line.rolling));
        EXPECT_NEAR(ComputedRolling<double>::of(contact).force(oiled, line.rolling) / resistance, 1.0, 0.05)
            << material << ' ' << speed << ' ' << load;
        const double ratio = resistance / RollingResistance<double>::of(contact).force(oiled, line.rolling);
        EXPECT_GT(ratio, load < 1e-5 ? 0.1 : 0.75);
        EXPECT_LT(ratio, 1.8);
      }
}

// Light loads: rigid cylinders, whose resistance is the law's other asymptote, whatever the oil does under
// pressure. The inlet is so long that its end matters no more.
TEST(ReynoldsLine, RollingResistanceOfRigidCylinders) {
  const double speed = 1e-10, load = 1e-7;
  const LineFilmCase line = of_groups(speed, load);
  const double unit = std::sqrt(2.0 * 4.896 * speed / load) / std::sqrt(8.0 * load / std::numbers::pi);
  const LineFilm film = solve_line_film(line, {.cells = 1536, .inlet = 96.0 * unit, .outlet = 2.0 * unit});
  ASSERT_TRUE(film.converged);
  const double M = load / std::sqrt(2.0 * speed);
  const double group =
      (film.rolling_traction + film.inlet_beyond) / (modulus * radius * std::pow(2.0 * speed, 0.75));
  EXPECT_NEAR(group / (ComputedRolling<double>::kRigid * std::sqrt(M)), 1.0, 1e-3);
}

TEST(ReynoldsLine, EyringsOilThinsTheFilmThatSlides) {
  LineFilmCase slides = of_groups(1e-11, 3e-5);
  const double newton = solve_line_film(slides).central;
  slides.oil.eyring_stress = 5e5;
  EXPECT_EQ(solve_line_film(slides).central, newton);
  slides.sliding = 0.5 * slides.rolling;
  EXPECT_LT(solve_line_film(slides).central, newton);
}

}  // namespace
}  // namespace orbearing::bearing::film::reynolds_line_test
