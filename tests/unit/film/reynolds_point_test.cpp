// Reynolds' equation of an elliptical contact that rolls and spins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/film/reynolds/point.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::film::reynolds_point_test {
namespace {

constexpr double radius = 0.01, modulus = 2.28e11;

// In the groups of [HamrockDowson1977]: U = eta u/(E' R), W = Q/(E' R^2).
PointFilmCase of_groups(double speed, double load, double ellipticity) {
  PointFilmCase contact{.modulus = modulus, .oil = {.viscosity = 0.02, .pressure_viscosity = 2e-8}};
  set_ellipse(contact, radius, ellipticity);
  contact.load = load * modulus * radius * radius;
  contact.rolling = speed * modulus * radius / contact.oil.viscosity;
  return contact;
}

const PointFilmCase round_contact = of_groups(2e-11, 5e-7, 1.0);
const PointFilmCase slender = of_groups(1e-11, 5e-7, 3.0);
constexpr PointFilmGrid coarse{.along = 64, .across = 64};

// The requested ratio of axes is the one that Hertz's theory returns: film without load nowhere near.
TEST(ReynoldsPoint, LoadBalancesAndMassIsKeptAlsoWhereOilCavitates) {
  for (const PointFilmCase& contact : {round_contact, slender}) {
    const PointFilm film = solve_point_film(contact, {.along = 128, .across = 128});
    ASSERT_TRUE(film.converged);
    EXPECT_LT(film.load_error, 1e-5);
    EXPECT_LT(film.residual, 1e-5);
    EXPECT_LT(film.mass_error, 1e-4);
    const double cell = (film.x[1] - film.x[0]) * (film.y[1] - film.y[0]);
    EXPECT_NEAR(film.pressure.sum() * cell / contact.load, 1.0, 1e-5);
    EXPECT_GE(film.pressure.minCoeff(), 0.0);
    // Oil or pressure: nowhere both a part of the gap and a pressure.
    EXPECT_EQ((film.pressure * (1.0 - film.fraction)).abs().maxCoeff(), 0.0);
    EXPECT_LT(film.fraction.minCoeff(), 0.5);
  }
}

// Without spin all oil moves along the rolling: beyond the last pressure every line across passes as much.
TEST(ReynoldsPoint, FlowIsKeptBeyondTheEdgeOfCavitation) {
  PointFilmCase thin = round_contact;
  thin.oil.compressible = false;
  const PointFilm film = solve_point_film(thin, coarse);
  ASSERT_TRUE(film.converged);
  const Eigen::Index n = film.x.size() - 1, across = film.y.size() - 2;
  Eigen::Index edge = n;
  while (film.pressure.row(edge).maxCoeff() <= 0.0) --edge;
  const auto oil = [&](Eigen::Index i) {
    return (film.film.row(i) * film.fraction.row(i)).segment(1, across).sum();
  };
  const auto carried = [&](Eigen::Index i) { return 1.5 * oil(i) - 0.5 * oil(i - 1); };
  ASSERT_LT(edge + 4, n);
  EXPECT_NEAR(carried(n - 1) / carried(edge + 2), 1.0, 1e-9);
  EXPECT_LT(oil(n - 1), 0.9 * film.film.row(n - 1).segment(1, across).sum());
}

TEST(ReynoldsPoint, SymmetricWithoutSpin) {
  const PointFilm film = solve_point_film(slender, coarse);
  ASSERT_TRUE(film.converged);
  const Field mirrored = film.film.rowwise().reverse();
  EXPECT_LT((film.film - mirrored).abs().maxCoeff(), 1e-4 * film.central);
}

TEST(ReynoldsPoint, ARoundContactFeelsNoDirection) {
  PointFilmCase turned = round_contact;
  turned.angle = 0.7;
  const PointFilm film = solve_point_film(round_contact, coarse), other = solve_point_film(turned, coarse);
  EXPECT_NEAR(other.central / film.central, 1.0, 1e-9);
  EXPECT_NEAR(std::hypot(other.least_x, other.least_y), std::hypot(film.least_x, film.least_y),
              1e-3 * radius);
}

// Rolling along the long axis is the contact with its curvatures swapped.
TEST(ReynoldsPoint, RollingAcrossIsTheOtherContact) {
  PointFilmCase across = slender, swapped = slender;
  across.angle = 0.5 * std::numbers::pi;
  std::swap(swapped.curvature_x, swapped.curvature_y);
  const PointFilm film = solve_point_film(across, coarse), other = solve_point_film(swapped, coarse);
  ASSERT_TRUE(film.converged && other.converged);
  EXPECT_NEAR(film.central / other.central, 1.0, 1e-6);
  EXPECT_LT(film.central, solve_point_film(slender, coarse).central);
}

// Between both, the film lies between theirs.
TEST(ReynoldsPoint, AnyAngleOfRolling) {
  PointFilmCase inclined = slender, across = slender;
  inclined.angle = 0.25 * std::numbers::pi;
  across.angle = 0.5 * std::numbers::pi;
  const PointFilm film = solve_point_film(inclined, {.along = 128, .across = 128});
  ASSERT_TRUE(film.converged);
  EXPECT_LT(film.central, solve_point_film(slender, coarse).central);
  EXPECT_GT(film.central, solve_point_film(across, coarse).central);
}

TEST(ReynoldsPoint, SlightSpinIsNone) {
  PointFilmCase spun = slender;
  spun.spin = 1e-3;
  const PointFilm film = solve_point_film(spun, coarse), still = solve_point_film(slender, coarse);
  EXPECT_NEAR(film.central / still.central, 1.0, 1e-5);
  EXPECT_NEAR(film.least / still.least, 1.0, 1e-4);
}

// v_x = rolling + spin y/2: with a positive spin oil enters slower where y is negative.
TEST(ReynoldsPoint, SpinLowersTheLeastFilmOnTheSlowSideAndLeavesTheCentralOne) {
  const PointFilmGrid grid{.along = 128, .across = 128};
  const PointFilm still = solve_point_film(slender, grid);
  double before = still.least;
  for (const double spin : {300.0, 600.0, 1200.0}) {
    PointFilmCase spun = slender;
    spun.spin = spin;
    const PointFilm film = solve_point_film(spun, grid);
    ASSERT_TRUE(film.converged) << spin;
    EXPECT_NEAR(film.central / still.central, 1.0, 0.02) << spin;
    EXPECT_LT(film.least, before) << spin;
    EXPECT_LT(film.least_y, 0.0) << spin;
    before = film.least;
    spun.spin = -spin;
    const PointFilm mirrored = solve_point_film(spun, grid);
    EXPECT_NEAR(mirrored.least / film.least, 1.0, 1e-3) << spin;
    EXPECT_NEAR(mirrored.least_y / film.least_y, -1.0, 1e-2) << spin;
  }
}

// The contact of [Guo2013] at 500 N and more, heavy loads on slender ellipses, much spin on them: cells are
// then several times as long across as along.
TEST(ReynoldsPoint, SolvesHeavilyLoadedSlenderEllipsesAlsoWithMuchSpin) {
  PointFilmCase guo{.modulus = 226e9, .oil = {.viscosity = 0.01988, .pressure_viscosity = 19.75e-9}};
  set_ellipse(guo, 5.24e-3, 8.813);
  struct {
    double load, rolling, spin;
  } const points[]{{500.0, 5.0, 0.0},
                   {500.0, 5.0, 200.0},
                   {500.0, 15.0, 400.0},
                   {500.0, 5.0, 3000.0},
                   {2000.0, 5.0, 200.0}};
  for (const auto& point : points) {
    PointFilmCase one = guo;
    one.load = point.load;
    one.rolling = point.rolling;
    one.spin = point.spin;
    EXPECT_TRUE(solve_point_film(one).converged) << point.load << " N, " << point.spin << " rad/s";
  }
  PointFilmCase six = of_groups(1e-11, 1e-5, 6.0);
  EXPECT_TRUE(solve_point_film(six).converged);
  six = of_groups(1e-11, 1e-6, 6.0);
  six.spin = 3000.0;
  EXPECT_TRUE(solve_point_film(six).converged);
}

// Surfaces that rotate against each other ten times as fast as they roll, and a film of a tenth of a squared
// step: no solution, which is reported in reasonable time.
TEST(ReynoldsPoint, WhatIsNotSolvedIsGivenUp) {
  PointFilmCase turns = of_groups(1e-11, 1e-6, 6.0), thin = of_groups(1e-14, 1e-4, 1.0);
  turns.spin = 20000.0;
  for (const PointFilmCase& contact : {turns, thin}) {
    const PointFilm film = solve_point_film(contact);
    EXPECT_FALSE(film.converged);
    EXPECT_LE(film.cycles, 60);  // on the finest grid, all attempts together
  }
}

// At a heavy load and slow rolling pressure and approach become those of Hertz.
TEST(ReynoldsPoint, HertzsContactIsTheLimit) {
  PointFilmCase heavy = of_groups(1e-11, 2e-6, 1.0);
  const PointFilm film = solve_point_film(heavy, {.along = 128, .across = 128});
  ASSERT_TRUE(film.converged);
  const double a = std::cbrt(1.5 * heavy.load * radius / modulus);  // E' is twice Hertz's
  const double largest = 1.5 * heavy.load / (std::numbers::pi * a * a);
  EXPECT_NEAR(film.largest_pressure / largest, 1.0, 0.02);
  EXPECT_NEAR((film.approach + film.central) / (a * a / radius), 1.0, 0.02);
}

// Errors fall fourfold from grid to grid, wherever the contact lies on it.
TEST(ReynoldsPoint, SecondOrder) {
  for (const double shift : {0.0, 0.37}) {
    double central[3], least[3];
    for (int level = 0; level < 3; ++level) {
      const int cells = 64 << level;
      const double scale = 1 << level;  // the same place on every grid
      const PointFilm film = solve_point_film(of_groups(5e-11, 5e-7, 2.0), {.along = cells,
                                                                            .across = cells,
                                                                            .inlet = 4.5,
                                                                            .outlet = 1.75,
                                                                            .side = 2.5,
                                                                            .shift_x = shift * scale,
                                                                            .shift_y = 0.6 * shift * scale});
      ASSERT_TRUE(film.converged);
      central[level] = film.central;
      least[level] = film.least;
    }
    const auto ratio = [](const double* f) { return (f[1] - f[0]) / (f[2] - f[1]); };
    EXPECT_GT(ratio(central), 3.0) << shift;
    EXPECT_LT(ratio(central), 5.5) << shift;
    EXPECT_GT(ratio(least), 2.5) << shift;  // the place of the least film moves between nodes
  }
}

TEST(ReynoldsPoint, EyringsOilThinsTheFilmThatSlides) {
  PointFilmCase slides = round_contact;
  slides.sliding = 0.5 * slides.rolling;
  const double newton = solve_point_film(slides, coarse).central;
  slides.oil.eyring_stress = 1e12;
  EXPECT_NEAR(solve_point_film(slides, coarse).central / newton, 1.0, 1e-6);
  slides.oil.eyring_stress = 5e5;
  const PointFilm thin = solve_point_film(slides, coarse);
  ASSERT_TRUE(thin.converged);
  EXPECT_LT(thin.central, newton);
  slides.sliding = 0.0;
  EXPECT_NEAR(solve_point_film(slides, coarse).central / newton, 1.0, 1e-9);
}

TEST(ReynoldsPoint, WhatHasNoMeaningIsRefused) {
  PointFilmCase wrong = round_contact;
  wrong.load = 0.0;
  EXPECT_THROW(solve_point_film(wrong), std::invalid_argument);
  wrong = round_contact;
  wrong.rolling = 0.0;
  EXPECT_THROW(solve_point_film(wrong), std::invalid_argument);
  EXPECT_THROW(solve_point_film(round_contact, {.along = 100}), std::invalid_argument);
}

// The law of rolling resistance was fitted to ellipses of 2 to 12. In grooves as wide as 1.4 ball diameters
// ellipses are nearly circles: the law holds there as well. The force on each surface is the first moment of
// the pressure over 2 R_x.
TEST(ReynoldsPoint, RollingResistanceInWideGroovesIsThatOfTheLawForBalls) {
  for (const double osculation : {0.7, 1.0, 1.4}) {
    Bearing bearing;
    bearing.elements = Balls{.count = 3, .diameter = 3e-3, .contact_angle = 85.0 * constants::degree};
    bearing.pitch_diameter = 36e-3;
    bearing.inner.osculation = bearing.outer.osculation = osculation;
    bearing.width = 10e-3;
    bearing.cage = {.inner_diameter = 35e-3, .outer_diameter = 37e-3, .width = 4e-3, .density = 1310.0};
    balls::MotionParameters given;
    given.lubricant = {.viscosity = 0.05, .pressure_viscosity = 2e-8};
    given.race.rolling_resistance = true;
    given.ellipse.rolling = balls::BallRolling::reynolds;
    const balls::GrooveNumbers groove = balls::ball_numbers(bearing, given).inner;
    for (const double load : {0.6, 6.0}) {
      PointFilmCase contact{.modulus = bearing.material.plane_strain_modulus(),
                            .oil = {.viscosity = 0.05, .pressure_viscosity = 2e-8},
                            .load = load,
                            .rolling = 0.12};
      set_ellipse(contact, groove.rolling_radius, groove.across / groove.along);
      const PointFilm film = solve_point_film(contact, {.along = 128, .across = 64});
      ASSERT_TRUE(film.converged);
      const double cell = (film.x[1] - film.x[0]) * (film.y[1] - film.y[0]);
      const double moment = -(film.pressure.colwise() * film.x).sum() * cell;
      const double couple = groove.rolling_factor * contact.rolling *
                            groove.rolling.per_speed(std::log(contact.rolling), std::log(load));
      EXPECT_NEAR(moment / couple, 1.0, 0.06)
          << groove.across / groove.along << " " << osculation << " " << load << " N";
    }
  }
}

}  // namespace
}  // namespace orbearing::bearing::film::reynolds_point_test
