// Kinematics of a ball in its pocket, Eqs. (14) to (18) of [Chen2026], and forces on both bodies.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "bearing/motion/balls/pocket_contact.hpp"
#include "tests/shortest_turn.hpp"

namespace orbearing::bearing::balls::pocket_contact_test {
namespace {

constexpr double kBallRadius = 4.76e-3, kPlay = 0.1e-3, kPitch = 18e-3;

BallNumbers numbers(double straight) {
  BallNumbers c;
  c.radius = kBallRadius;
  c.pocket = {.play = kPlay, .half_straight = 0.5 * straight, .stiffness = 1e9, .friction = 0.1, .sliding_scale = 0.01};
  return c;
}

// A ball at angle zero, off the pocket's middle by `ahead` along the pitch circle and `axial`.
PocketTouch<double> touch(const BallNumbers& c, double ahead, double axial) {
  const Ball<double> ball{kPitch, 0.0, 1.0, 0.0, {}, {}, 0.0};
  const Body cage{{0.0, -ahead, -axial}, {0.0, 0.0, 1.0}, {}, {}, 0.0};
  ContactSlopes<double> unused;
  PocketFilmSlopes<double> none;
  return pocket_touch<false>(c, ball, seen(ball, cage), Triple<double>{1.0, 0.0, 0.0}, unused, none);
}

TEST(PocketContact, RoundPocketsCountTheDistanceFromTheirMiddle) {
  const BallNumbers c = numbers(0.0);
  EXPECT_NEAR(touch(c, 0.03e-3, 0.04e-3).approach, 0.05e-3 - kPlay, 1e-15);
  EXPECT_NEAR(touch(c, -0.09e-3, 0.12e-3).approach, 0.15e-3 - kPlay, 1e-15);
}

// Eq. (14): the straight part holds the ball axially alone; beyond it, the half circle about its end.
TEST(PocketContact, OblongPocketsCountFromTheNearestPointOfTheirMiddleLine) {
  const BallNumbers c = numbers(0.2e-3);
  EXPECT_NEAR(touch(c, 0.08e-3, 0.12e-3).approach, 0.12e-3 - kPlay, 1e-15);
  EXPECT_NEAR(touch(c, 0.22e-3, 0.05e-3).approach, std::hypot(0.12e-3, 0.05e-3) - kPlay, 1e-15);
  EXPECT_NEAR(touch(c, -0.25e-3, 0.0).approach, 0.15e-3 - kPlay, 1e-15);
}

TEST(PocketContact, PushesTheBallBackAndDrivesTheCage) {
  const PocketTouch<double> ahead = touch(numbers(0.0), 0.15e-3, 0.0);
  EXPECT_NEAR(ahead.load, 1e9 * std::pow(0.05e-3, 1.5), 1e-9 * ahead.load);
  EXPECT_LT(ahead.on_ball.force.y, 0.0);
  EXPECT_GT(ahead.driving, 0.0);
  EXPECT_EQ(touch(numbers(0.0), 0.05e-3, 0.0).load, 0.0);
}

// Eqs. (23) to (25): oil between ball and pocket before they touch.
struct Film {
  BallNumbers c = numbers(0.0);
  Film() { c.pocket.film = RigidPointFilm::between(0.02, kBallRadius, kBallRadius * (kBallRadius + kPlay) / kPlay, 2e-3, kBallRadius, 0.4e-6); }

  // The ball `ahead` [m] of the middle, moving ahead and turning about its own axis.
  PocketTouch<double> at(double ahead, double speed, double rotating, double axial = 0.0) const {
    const Ball<double> ball{kPitch, axial, 1.0, 0.0, {0.0, speed, 0.0}, {0.0, 0.0, rotating}, 0.0};
    const Body cage{{0.0, -ahead, 0.0}, {0.0, 0.0, 1.0}, {}, {}, 0.0};
    ContactSlopes<double> unused;
    PocketFilmSlopes<double> none;
    return pocket_touch<false>(c, ball, seen(ball, cage), Triple<double>{1.0, 0.0, 0.0}, unused, none);
  }
};

// Taylor's sphere before a plane, and the film of [Kapitza1955] that carries on one half.
TEST(PocketContact, FilmIsThatOfTaylorAndKapitza) {
  const double radius = 5e-3, eta = 0.03, gap = 2e-6;
  const RigidPointFilm film = RigidPointFilm::between(eta, radius, radius, radius, radius, 1e-9);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(film.at(gap, 1e-3, 0.0, 0.0).load, 6.0 * pi * eta * radius * radius * 1e-3 / gap, 1e-9);
  EXPECT_NEAR(film.at(gap, 0.0, 0.7, 0.0).load,
              12.0 * eta * 0.7 / 5.0 * radius * pi * std::sqrt(2.0 * radius / gap), 1e-9);
  EXPECT_LT(film.at(gap, -1e-3, 0.0, 0.0).load, 1e-9);
}

// The pressure summed over a grid, cut where it would be negative.
TEST(PocketContact, FilmIsTheIntegralOfItsPressure) {
  const double rx = 4e-3, ry = 30e-3, eta = 0.02, gap = 5e-6, closing = 2e-3, ux = 0.05, uy = -0.08;
  const RigidPointFilm film = RigidPointFilm::between(eta, rx, ry, rx, rx, 1e-9);
  const double c = 6.0 * eta * closing / (1.0 / rx + 1.0 / ry);
  const double ax = 12.0 * eta * ux / (3.0 + 2.0 * rx / ry), ay = 12.0 * eta * uy / (3.0 + 2.0 * ry / rx);
  // Polar, with the radius mapped by its tangent so that the whole plane is included.
  double sum = 0.0;
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double t = (i + 0.5) / n * std::acos(0.0), angle = (k + 0.5) / n * 4.0 * std::acos(0.0);
      const double r = std::tan(t), area = r * (1.0 + r * r) * std::acos(0.0) / n * 4.0 * std::acos(0.0) / n;
      const double x = std::sqrt(2.0 * rx * gap) * r * std::cos(angle), y = std::sqrt(2.0 * ry * gap) * r * std::sin(angle);
      const double h = gap * (1.0 + r * r);
      sum += std::max(0.0, (c - ax * x - ay * y) / (h * h)) * area * 2.0 * gap * std::sqrt(rx * ry);
    }
  EXPECT_NEAR(film.at(gap, closing, ux, uy).load, sum, 2e-3 * sum);
}

TEST(PocketContact, FilmResistsSqueezeInTheMiddleAndLiftsTheTurningBallOffTheNearerSide) {
  const Film film;
  EXPECT_GT(film.at(1e-9, 0.01, 0.0).load, 0.0);
  EXPECT_NEAR(film.at(1e-9, 0.01, 0.0).load, -film.at(1e-9, -0.01, 0.0).load, 1e-4 * film.at(1e-9, 0.01, 0.0).load);
  EXPECT_NEAR(film.at(1e-9, 0.0, 300.0).load, 0.0, 1e-4 * film.at(0.09e-3, 0.0, 300.0).load);
  EXPECT_GT(film.at(0.09e-3, 0.0, 300.0).load, film.at(0.05e-3, 0.0, 300.0).load);
  EXPECT_LT(film.at(0.09e-3, 0.0, 300.0).on_ball.force.y, 0.0);
  EXPECT_LT(film.at(1e-9, 0.0, 300.0).on_ball.moment.z, 0.0);
}

// In the middle no direction is distinguished: squeeze resists all equally.
TEST(PocketContact, FilmIsTheSameAllRoundInTheMiddle) {
  const Film film;
  const double along = -film.at(1e-9, 0.01, 0.0).on_ball.force.y;
  const double across = -film.at(0.0, 0.01, 0.0, 1e-9).on_ball.force.y;
  EXPECT_NEAR(across, along, 1e-2 * along);
}

TEST(PocketContact, FilmLosesPower) {
  const Film film;
  for (const double ahead : {0.0, 0.05e-3, 0.0995e-3, 0.12e-3})
    for (const double speed : {-0.2, -0.01, 0.0, 0.01, 0.2})
      for (const double rotating : {-900.0, -20.0, 0.0, 300.0}) {
        const PocketTouch<double> now = film.at(ahead, speed, rotating, 0.01e-3);
        EXPECT_GE(now.film_power, 0.0) << ahead << " " << speed << " " << rotating;
      }
}

TEST(PocketContact, SlopesOfTheFilmAreThoseOfItsLoad) {
  const RigidPointFilm film = Film().c.pocket.film;
  for (const double gap : {1e-6, 2e-5})
    for (const double closing : {-3e-3, 2e-3}) {
      const auto load = [&](double g, double v) { return film.at(g, v, 0.2, 0.1).load; };
      const auto now = film.at(gap, closing, 0.2, 0.1);
      const double h = 1e-4 * gap, v = 1e-7;
      const double by_gap = (load(gap + h, closing) - load(gap - h, closing)) / (2 * h);
      const double by_closing = (load(gap, closing + v) - load(gap, closing - v)) / (2 * v);
      EXPECT_NEAR(now.by_gap, by_gap, 1e-6 * std::abs(by_gap));
      EXPECT_NEAR(now.by_closing, by_closing, 1e-6 * by_closing);
      const auto drawn = [&](double ux, double uy) { return film.at(gap, closing, ux, uy).load; };
      EXPECT_NEAR(now.by_ux, (drawn(0.2 + v, 0.1) - drawn(0.2 - v, 0.1)) / (2 * v), 1e-5 * std::abs(now.by_ux));
      EXPECT_NEAR(now.by_uy, (drawn(0.2, 0.1 + v) - drawn(0.2, 0.1 - v)) / (2 * v), 1e-5 * std::abs(now.by_uy));
    }
}

// The same of both sides together, by every motion of the ball in its pocket.
TEST(PocketContact, SlopesOfBothSidesAreThoseOfTheirLoad) {
  const Film film;
  const ContactAxes<double> axes{.normal = {0.0, 1.0, 0.0}, .along = {0.0, 0.0, 1.0}, .across = {1.0, 0.0, 0.0}};
  const auto at = [&](double distance, const Triple<double>& speed, const Triple<double>& turn,
                      PocketFilmSlopes<double>& slopes) {
    PocketTouch<double> touch{};
    slopes = {};
    add_pocket_film<true>(film.c, axes, distance, 0.0, speed, turn, touch, slopes);
    return touch.load;
  };
  const double position = 0.04e-3;
  const Triple<double> speed{0.3, -2e-3, 0.2}, turn{40.0, 15.0, -60.0};
  PocketFilmSlopes<double> slopes{}, unused{};
  at(position, speed, turn, slopes);
  const auto by = [&](double h, auto&& moved) { return (moved(h) - moved(-h)) / (2.0 * h); };
  const auto by_speed = [&](const Triple<double>& way) {
    return by(1e-7, [&](double v) { return at(position, speed + mechanics::scaled(v, way), turn, unused); });
  };
  const auto by_turn = [&](const Triple<double>& way) {
    return by(1e-4, [&](double w) { return at(position, speed, turn + mechanics::scaled(w, way), unused); });
  };
  constexpr double kDifference = 1e-5;  // relative, of differences over such steps
  const auto expect = [&](double slope, double difference, const char* what) {
    EXPECT_GT(std::abs(difference), 0.0) << what;
    EXPECT_NEAR(slope, difference, kDifference * std::abs(difference)) << what;
  };
  const double h = 1e-10;
  expect(slopes.by_approach, by(h, [&](double x) { return at(position + x, speed, turn, unused); }),
         "approach");
  expect(slopes.by_speed, -by_speed(axes.normal), "speed");
  expect(slopes.by_along, by_speed(axes.along), "along");
  expect(slopes.by_across, by_speed(axes.across), "across");
  expect(slopes.by_turning_across, by_turn(axes.across), "turning about across");
  expect(slopes.by_turning_along, by_turn(axes.along), "turning about along");
}

// Eq. (17): the pocket's direction in a tilted cage is that of the shortest turn of its axis.
TEST(PocketContact, DirectionsTurnWithTheAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.02, -0.03, 1.0).normalized();
  const Eigen::Quaterniond turn = shortest_turn(Eigen::Vector3d::UnitZ(), axis);
  for (const double angle : {0.0, 0.7, 2.5, -1.9}) {
    const Triple<double> ours =
        pocket_direction<double>({axis.x(), axis.y(), axis.z()}, std::cos(angle), std::sin(angle));
    const Eigen::Vector3d exact = turn * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    EXPECT_NEAR(ours.x, exact.x(), 1e-15);
    EXPECT_NEAR(ours.y, exact.y(), 1e-15);
    EXPECT_NEAR(ours.z, exact.z(), 1e-15);
  }
}

}  // namespace
}  // namespace orbearing::bearing::balls::pocket_contact_test
