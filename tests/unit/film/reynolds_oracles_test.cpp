// Films of Reynolds' equation against results that do not come from the same equations: the line solver in
// the middle of slender ellipses, the interpolations of Moes and others between asymptotes, the density under
// pressure.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bearing/film/reynolds/line.hpp"
#include "bearing/film/reynolds/point.hpp"

namespace orbearing::bearing::film::reynolds_oracles_test {
namespace {

constexpr double radius = 0.01, modulus = 2.28e11, viscosity = 0.02, pressure_viscosity = 2e-8;

struct Groups {
  double speed = 0.0;        // U = eta u/(E' R)
  double load = 0.0;         // W
  double ellipticity = 1.0;  // [-]
};

PointFilmCase point_of(const Groups& groups) {
  PointFilmCase contact{.modulus = modulus,
                        .oil = {.viscosity = viscosity, .pressure_viscosity = pressure_viscosity}};
  set_ellipse(contact, radius, groups.ellipticity);
  contact.load = groups.load * modulus * radius * radius;
  contact.rolling = groups.speed * modulus * radius / viscosity;
  return contact;
}

// Hertz's largest pressure [Pa] of an ellipse of a ratio of axes above 1.
double hertz_pressure(const PointFilmCase& contact, double ratio) {
  const double second = std::comp_ellint_2(std::sqrt(1.0 - 1.0 / (ratio * ratio)));
  const double sum = contact.curvature_x + contact.curvature_y;
  const double major =
      std::cbrt(6.0 * ratio * ratio * second * contact.load / (std::numbers::pi * sum * modulus));
  return 1.5 * contact.load * ratio / (std::numbers::pi * major * major);
}

// A line contact of the same largest pressure, oil and speed is the limit in the plane of symmetry.
TEST(ReynoldsOracles, TheMiddleOfASlenderEllipseIsALineContact) {
  for (const Groups& groups :
       {Groups{5e-12, 1e-6, 10.0}, Groups{1e-11, 1e-5, 10.0}, Groups{5e-11, 1e-5, 10.0},
        Groups{5e-12, 1e-6, 6.0}, Groups{5e-11, 1e-5, 6.0}}) {
    const PointFilmCase point = point_of(groups);
    const double pressure = hertz_pressure(point, groups.ellipticity);
    const double half_width = 4.0 * radius * pressure / modulus;
    const LineFilmCase line{.radius = radius,
                            .modulus = modulus,
                            .oil = point.oil,
                            .load = std::numbers::pi * modulus * half_width * half_width / (8.0 * radius),
                            .rolling = point.rolling};
    const PointFilm film = solve_point_film(point, {.along = 256, .across = 128});
    const LineFilm limit = solve_line_film(line, {.cells = 512});
    ASSERT_TRUE(film.converged && limit.converged);
    EXPECT_NEAR(film.central / limit.central, 1.0, 0.02) << groups.speed << ' ' << groups.load;
    EXPECT_NEAR(film.least / limit.least, 1.0, 0.03) << groups.speed << ' ' << groups.load;
  }
}

// Central film over the radius, [NijenbanningVennerMoes1994]; curvature across over that along `ratio`.
double interpolated_central(const Groups& groups, double ratio) {
  const double speeds = 2.0 * groups.speed;  // of the sum of both surfaces'
  const double M = groups.load * std::pow(speeds, -0.75);
  const double L = pressure_viscosity * modulus * std::pow(speeds, 0.25);
  const double shape = 1.0 + 0.006 * std::log(ratio) + 0.63 * std::pow(ratio, 4.0 / 7.0);
  const double rigid =
      145.0 * std::pow(1.0 + 0.796 * std::pow(ratio, 14.0 / 15.0), -15.0 / 7.0) / (ratio * M * M);
  const double elastic =
      3.18 * std::pow(shape, -14.0 / 25.0) * std::pow(ratio, -1.0 / 15.0) * std::pow(M, -2.0 / 15.0);
  const double rigid_thick = 1.29 * std::pow(1.0 + 0.691 * ratio, -2.0 / 3.0) * std::pow(L, 2.0 / 3.0);
  const double elastic_thick = 1.48 * std::pow(shape, -7.0 / 20.0) * std::pow(ratio, -1.0 / 24.0) *
                               std::pow(M, -1.0 / 12.0) * std::pow(L, 0.75);
  const double none = 1.8 / ratio;
  const double s = 1.5 * (1.0 + std::exp(-1.2 * elastic / elastic_thick));
  const double one = std::pow(rigid, 1.5) + std::pow(std::pow(elastic, -4.0) + std::pow(none, -4.0), -0.375);
  const double other = std::pow(std::pow(rigid_thick, -8.0) + std::pow(elastic_thick, -8.0), -0.125 * s);
  return std::pow(std::pow(one, 2.0 * s / 3.0) + other, 1.0 / s) * std::sqrt(speeds);
}

// At pressures where oil is hardly denser: 5 %, ellipticity 1 to 3.
TEST(ReynoldsOracles, CentralFilmsOfModeratePressuresMeetTheInterpolationBetweenAsymptotes) {
  for (const Groups& groups : {Groups{5e-12, 1.1e-7, 1.0}, Groups{5e-12, 1.1e-7, 1.5},
                               Groups{5e-12, 1.1e-7, 2.0}, Groups{5e-12, 1.1e-7, 3.0}}) {
    const PointFilmCase point = point_of(groups);
    const PointFilm film = solve_point_film(point);
    ASSERT_TRUE(film.converged);
    const double expected = radius * interpolated_central(groups, point.curvature_y / point.curvature_x);
    EXPECT_NEAR(film.central / expected, 1.0, 0.05) << groups.ellipticity;
  }
}

// The inlet, where viscosity has grown by e, sets the mass that passes: where oil is denser by a fifth than
// there the film is thinner by as much. This is most
// of what central films at high pressures lack against regressions; the least film, at low pressure, keeps
// its height.
TEST(ReynoldsOracles, CentralFilmsAreThinnerByTheDensityOfTheirOil) {
  for (const Groups& groups : {Groups{5e-12, 1.1e-6, 2.0}, Groups{1e-11, 1e-5, 6.0}}) {
    const PointFilmCase dense = point_of(groups);
    PointFilmCase same = dense;
    same.oil.compressible = false;
    const PointFilm film = solve_point_film(dense), other = solve_point_film(same);
    ASSERT_TRUE(film.converged && other.converged);
    const OilUnderPressure oil(dense.oil);
    const double density =
        oil.at(hertz_pressure(dense, groups.ellipticity)).density / oil.at(1.0 / pressure_viscosity).density;
    EXPECT_GT(density, 1.1);
    EXPECT_NEAR(other.central / film.central / density, 1.0, 0.02) << groups.load;
    EXPECT_NEAR(other.least / film.least, 1.0, 0.05) << groups.load;
  }
}

// Moes' interpolation for lines: flow over both speeds' sum, in R sqrt(speeds).
double interpolated_line(double M, double L) {
  const double rigid = 3.0 / M, elastic = 2.621 * std::pow(M, -0.2);
  const double rigid_thick = 1.287 * std::pow(L, 2.0 / 3.0);
  const double elastic_thick = 1.311 * std::pow(M, -0.125) * std::pow(L, 0.75);
  const double s = 0.2 * (7.0 + 8.0 * std::exp(-2.0 * elastic / rigid));
  const double thin = std::pow(std::pow(rigid, 7.0 / 3.0) + std::pow(elastic, 7.0 / 3.0), 3.0 * s / 7.0);
  const double thick = std::pow(std::pow(rigid_thick, -3.5) + std::pow(elastic_thick, -3.5), -2.0 * s / 7.0);
  return std::pow(thin + thick, 1.0 / s);
}

// The four regimes of [Moes1965], rigid or elastic bodies, oil of one viscosity or not: one point well in
// each.
TEST(ReynoldsOracles, LinesMeetTheFourRegimesOfMoes) {
  constexpr double speeds = 2e-11;
  struct {
    double M, L, asymptote, tolerance;
  } const regimes[]{{0.1, 0.0, 3.0 / 0.1, 0.03},                           // rigid
                    {30.0, 0.0, 2.621 * std::pow(30.0, -0.2), 0.05},       // elastic
                    {1.0, 20.0, 1.287 * std::pow(20.0, 2.0 / 3.0), 0.10},  // rigid, piezoviscous
                    {100.0, 20.0, 1.311 * std::pow(100.0, -0.125) * std::pow(20.0, 0.75), 0.05}};  // elastic
  for (const auto& one : regimes) {
    LineFilmCase line{.radius = radius, .modulus = modulus, .oil = {.viscosity = viscosity}};
    line.oil.compressible = false;
    line.oil.pressure_viscosity = one.L / std::pow(speeds, 0.25) / modulus;
    line.load = one.M * std::sqrt(speeds) * modulus * radius;
    line.rolling = 0.5 * speeds * modulus * radius / viscosity;
    const LineFilm film = solve_line_film(line, {.cells = 768});
    ASSERT_TRUE(film.converged) << one.M << ' ' << one.L;
    const Eigen::Index last = film.x.size() - 1;  // oil that leaves, as a film
    const double flow = film.fraction[last] * film.film[last] / (radius * std::sqrt(speeds));
    EXPECT_NEAR(flow / one.asymptote, 1.0, one.tolerance) << one.M << ' ' << one.L;
    EXPECT_NEAR(flow / interpolated_line(one.M, std::max(one.L, 1e-6)), 1.0, 0.07) << one.M << ' ' << one.L;
  }
}

// Twice the inlet and sides, a longer outlet, on cells of the same size: films of loaded contacts stay.
TEST(ReynoldsOracles, FilmsDoNotFeelTheEndOfTheDomain) {
  const PointFilmCase contact = point_of({1e-11, 1e-6, 2.0});
  const PointFilm film =
      solve_point_film(contact, {.along = 128, .across = 64, .inlet = 4.5, .outlet = 1.5, .side = 2.5});
  const PointFilm longer =
      solve_point_film(contact, {.along = 256, .across = 128, .inlet = 9.75, .outlet = 2.25, .side = 5.0});
  ASSERT_TRUE(film.converged && longer.converged);
  EXPECT_NEAR(longer.central / film.central, 1.0, 0.01);
  EXPECT_NEAR(longer.least / film.least, 1.0, 0.01);
}

}  // namespace
}  // namespace orbearing::bearing::film::reynolds_oracles_test
