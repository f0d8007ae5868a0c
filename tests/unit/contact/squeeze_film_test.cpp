// Oil that is pressed out between roller and race: closed forms of the rigid film, the share that a film
// takes of the closing speed, and a film whose thickness is a variable of its own.
#include "bearing/contact/squeeze_film.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bearing/contact/race_contact.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::squeeze_film_test {
namespace {

constexpr double kPi = M_PI;
constexpr double kRoughness = 0.2e-6;  // [m]

struct Contact {
  Bearing bearing = test::reducer_bearing();
  FilmContact oil = film_contact(bearing, geometry_of(bearing), Race::outer, {0.01, 1.5e-8});
  LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  FilmLaw<double> film = FilmLaw<double>::of(oil);
  SqueezeFilm<double> law = SqueezeFilm<double>::of(oil, kRoughness);

  // 3 sqrt(2) pi eta l R^(3/2)
  double squeeze_factor() const {
    return 3.0 * std::sqrt(2.0) * kPi * oil.lubricant.viscosity * oil.length *
           std::pow(oil.equivalent_radius, 1.5);
  }
};

// Normal approach of cylinder and plane at constant speed, to 1 %, without rolling and without contact.
TEST(SqueezeFilm, ApproachAtConstantSpeed) {
  const Contact contact;
  for (const double gap : {0.5e-6, 2e-6, 10e-6})
    for (const double speed : {1e-4, 1e-2, 1.0}) {
      const double expected = contact.squeeze_factor() * speed * std::pow(gap, -1.5);
      EXPECT_NEAR(contact.law.load(-gap, 0.0, gap, 1e-9, speed), expected, 1e-3 * expected);
    }
}

// The same at constant load: 2 C (h^(-1/2) - h_0^(-1/2)) = Q t.
TEST(SqueezeFilm, ApproachAtConstantLoad) {
  const Contact contact;
  constexpr double kLoad = 3.0, kFrom = 8e-6, kTo = 0.4e-6;  // [N], [m]
  const double expected =
      2.0 * contact.squeeze_factor() * (1.0 / std::sqrt(kTo) - 1.0 / std::sqrt(kFrom)) / kLoad;
  const auto closing = [&](double gap) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 100; ++i) {
      const double v = 0.5 * (low + high);
      (contact.law.load(-gap, 0.0, gap, 1e-9, v) < kLoad ? low : high) = v;
    }
    return low;
  };
  // dt = dh/V by Simpson's rule in ln h.
  constexpr int kPieces = 200;
  const double span = std::log(kFrom / kTo);
  double sum = 0.0;
  for (int i = 0; i <= kPieces; ++i) {
    const double gap = kTo * std::exp(span * i / kPieces);
    sum += (i == 0 || i == kPieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * gap / closing(gap);
  }
  EXPECT_NEAR(sum * span / (3.0 * kPieces), expected, 0.01 * expected);
}

// Rolling takes the oil away behind the contact: half of the resistance is left.
TEST(SqueezeFilm, HalfOfItWhereTheContactRolls) {
  const Contact contact;
  const double gap = 1e-6, slow = 1e-6,
               expected = 0.5 * contact.squeeze_factor() * slow * std::pow(gap, -1.5);
  EXPECT_NEAR(contact.law.load(-gap, 0.0, gap, 10.0, slow), expected, 1e-4 * expected);
  EXPECT_NEAR(contact.law.load(-gap, 0.0, gap, 10.0, -slow), -expected, 1e-4 * expected);
}

// The squeeze film takes away at most the load of the wedge where surfaces separate, and power is lost in
// every motion.
TEST(SqueezeFilm, NeverPullsAndNeverGives) {
  const Contact contact;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double elastic = 1e-5 * draw(random), load = contact.elastic.load(elastic);
    const double u = std::pow(10.0, 2.0 * draw(random)), v = std::pow(10.0, 3.0 * draw(random) - 2.0);
    const double gap = contact.law.gap(false, contact.film, elastic, elastic, load, std::log(u));
    const double closing = contact.law.load(elastic, load, gap, u, v);
    const double parting = contact.law.load(elastic, load, gap, u, -v);
    ASSERT_GT(closing, 0.0);
    ASSERT_LE(parting, 0.0);
    ASSERT_GE(parting, -contact.law.film.wedge(contact.law.film.slenderness(gap), u) * (1.0 + 1e-12));
    ASSERT_LE(-parting, closing);
  }
}

TEST(SqueezeFilm, GapIsTheDistanceOfBodiesThatDoNotTouchAndTheFilmOfThoseThatDo) {
  const Contact contact;
  const double u = std::log(8.0), central = std::exp(contact.film.log_unloaded(u));
  const auto filmed = [&](double approach) {
    return elastic_approach(contact.film, std::log(contact.elastic.constant()), approach, u).value;
  };
  for (const double approach : {-20e-6, -2e-6, -0.3e-6, 0.0, 0.4e-6, 5e-6}) {
    const double dry_load = contact.elastic.load(approach);
    const double dry = contact.law.gap(false, contact.film, approach, approach, dry_load, u);
    EXPECT_NEAR(
        dry, approach <= 0.0 ? central - approach : std::exp(contact.film.log_central(std::log(dry_load), u)),
        1e-12 * dry);
    const double elastic = filmed(approach), load = contact.elastic.load(elastic);
    const double wet = contact.law.gap(true, contact.film, approach, elastic, load, u);
    EXPECT_NEAR(wet, elastic <= 0.0 ? -approach : std::exp(contact.film.log_central(std::log(load), u)),
                1e-9 * wet);
  }
  // Held by the roughness.
  EXPECT_EQ(contact.law.gap(false, contact.film, 1e-6, 1e-6, 500.0, std::log(1e-3)), kRoughness);
}

// All of the closing is the film's where bodies do not touch, and next to nothing under load.
TEST(SqueezeFilm, ShareFallsWithTheLoad) {
  const Contact contact;
  EXPECT_EQ(contact.law.share(-1e-6, 0.0, 1.4e-6, 8.0), 1.0);
  double before = 1.0;
  for (double elastic = 1e-9; elastic < 2e-5; elastic *= 3.0) {
    const double load = contact.elastic.load(elastic);
    const double gap = contact.law.gap(false, contact.film, elastic, elastic, load, std::log(8.0));
    const double share = contact.law.share(elastic, load, gap, 8.0);
    EXPECT_LT(share, before);
    before = share;
  }
  EXPECT_LT(before, 0.01);
}

// A film with a thickness of its own, reduced by x, in series with the bodies under an approach that
// oscillates by a thousandth of both: (k_e + k_f) x + c x' = k_e a(t). In time, against the law's c s^2. One
// film, its rate included.
TEST(SqueezeFilm, DampsAsAFilmOfItsOwnThickness) {
  const Contact contact;
  for (const double load : {0.5, 5.0, 50.0, 500.0}) {
    const double elastic = std::pow(load / contact.elastic.constant(), 0.9), u = 8.0;
    const double gap = contact.law.gap(false, contact.film, elastic, elastic, load, std::log(u));
    const auto& rigid = contact.law.film;
    const double s = rigid.slenderness(gap), wedge = rigid.wedge(s, u), v = 1e-7;
    const double c = (rigid.squeeze(s, u, v) - rigid.squeeze(s, u, -v)) / (2.0 * v);
    const double k_f = load * (wedge + load) / ((wedge + 0.13 * load) * gap), k_e = load / (0.9 * elastic);
    const double omega = 0.05 * (k_e + k_f) / c, swing = 1e-3 * gap;
    // By the implicit midpoint rule, whose error is the square of a step's angle.
    constexpr int kSteps = 2000;  // a period
    const double dt = 2.0 * kPi / omega / kSteps, decay = 0.5 * dt * (k_e + k_f) / c;
    double taken = 0.0, lost = 0.0;
    for (int i = 0; i < 11 * kSteps; ++i) {
      const double from = swing * std::sin(omega * dt * i), to = swing * std::sin(omega * dt * (i + 1));
      const double before = taken, mean = 0.5 * (from + to);
      taken = ((1.0 - decay) * taken + dt * k_e / c * mean) / (1.0 + decay);
      if (i >= 10 * kSteps) lost += k_e * (mean - 0.5 * (before + taken)) * (to - from);
    }
    const double step = swing * omega;
    const double damping =
        (contact.law.load(elastic, load, gap, u, step) - contact.law.load(elastic, load, gap, u, -step)) /
        (2.0 * step);
    // The film lags by 0.05 rad: the law is off by the square of that.
    EXPECT_NEAR(kPi * damping * omega * swing * swing, lost, 4e-3 * lost) << load << " N";
  }
}

}  // namespace
}  // namespace orbearing::bearing::squeeze_film_test
