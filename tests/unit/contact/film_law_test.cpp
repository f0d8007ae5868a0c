// The film law, one source for numbers, their slopes and our own packs, against the film at one speed, the
// search for the elastic approach against both, and the search by powers against the one for any film.
#include "bearing/contact/film_law.hpp"

#include <gtest/gtest.h>

#include <random>

#define ORBEARING_PACKS film_law_test_packs
#include "bearing/contact/race_contact.hpp"
#include "bearing/motion/vectorised/race_load.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::film_law_test {
namespace {

using mechanics::variable;

constexpr double kRoundOff = 4e-12;     // ten operations on powers whose logarithms reach a hundred
constexpr double kSearchError = 1e-14;  // relative: where the search ends, and exp of logarithms of some tens
constexpr double kDifferenceError = 1e-7;  // relative: central differences with a step of 1e-5

FilmContact oiled_contact() {
  const Bearing bearing = test::reducer_bearing();
  return film_contact(bearing, geometry_of(bearing), Race::outer, {0.01, 1.5e-8});
}

// Powers of ten make it a hand calculation, as for Film: 4/3 2.65 x 10^-6.86 m at 1 kN and 10 m/s.
TEST(FilmLaw, ByHand) {
  const FilmContact contact{.equivalent_radius = 1e-2,
                            .length = 1e-2,
                            .reduced_modulus = 1e11,
                            .lubricant = {.viscosity = 1e-2, .pressure_viscosity = 1e-8}};
  const double expected = 4.0 / 3.0 * 2.65 * std::pow(10.0, -6.86);
  const double found = std::exp(FilmLaw<double>::of(contact).log_central(std::log(1e3), std::log(10.0)));
  EXPECT_NEAR(found, expected, kRoundOff * expected);
}

TEST(FilmLaw, CapIsWhereTheRigidFilmCrosses) {
  const FilmContact contact = oiled_contact();
  const auto law = FilmLaw<double>::of(contact);
  for (const double speed : {0.01, 1.0, 40.0}) {
    const double cap_load = std::exp(law.log_cap_load + law.kCapLoadSpeed * std::log(speed));
    const double rigid = 4.896 * 0.01 * speed * contact.equivalent_radius * contact.length / cap_load;
    EXPECT_NEAR(std::exp(law.log_central(std::log(0.1 * cap_load), std::log(speed))), rigid,
                kRoundOff * rigid);
    EXPECT_NEAR(std::exp(law.log_central(std::log(cap_load * (1.0 + 1e-13)), std::log(speed))), rigid,
                kRoundOff * rigid);
    EXPECT_NEAR(std::exp(law.log_unloaded(std::log(speed))), rigid, kRoundOff * rigid);
  }
}

TEST(FilmLaw, IntegralGrowsByTheFilm) {
  const auto law = FilmLaw<double>::of(oiled_contact());
  for (const double speed : {0.01, 1.0, 40.0})
    for (double load = 1e-3; load < 1e5; load *= 6.1) {
      const double u = std::log(speed);
      const double film = std::exp(law.log_central(std::log(load), u));
      const double step = 1e-4 * load;
      const double difference = film_integral(law, load + step, u) - film_integral(law, load - step, u);
      EXPECT_NEAR(difference, 2.0 * step * film, 1e-6 * step * film) << load;
      EXPECT_NEAR(film_integral(law, variable<0>(load), u).by<0>(), film, kRoundOff * film) << load;
    }
  EXPECT_NEAR(film_integral(law, 1e-200, 0.0), 0.0, 1e-200);
}

// A film that is no power law: both regimes run smoothly into each other.
struct SmoothFilm {
  FilmLaw<double> hard;

  template <class LogLoad, class LogSpeed>
  auto log_central(const LogLoad& log_load, const LogSpeed& log_speed) const {
    const auto over_cap = log_load - (FilmLaw<double>::kCapLoadSpeed * log_speed + hard.log_cap_load);
    const auto softened = logarithm(1.0 + exponential(over_cap));
    return hard.log_unloaded(log_speed) - FilmLaw<double>::kLoad * softened;
  }
  template <class LogSpeed>
  auto log_unloaded(const LogSpeed& log_speed) const {
    return hard.log_unloaded(log_speed);
  }
  static double logarithm(double x) { return std::log(x); }
  static double exponential(double x) { return std::exp(x); }
  template <class Dual>
  requires(mechanics::is_dual<Dual>) static auto logarithm(const Dual& x) { return mechanics::logarithm(x); }
  template <class Dual>
  requires(mechanics::is_dual<Dual>) static auto exponential(const Dual& x) {
    return mechanics::exponential(x);
  }
};

template <class Law>
void check_search(const Law& law) {
  const double stiffness = 8e8, log_stiffness = std::log(stiffness);
  const auto root = [&](double approach, double log_speed) {
    return elastic_approach(law, log_stiffness, approach, log_speed);
  };
  for (const double speed : {0.01, 1.0, 40.0})
    for (double e = 1e-12; e < 1e-3; e *= 4.3) {
      const double u = std::log(speed);
      const double film = std::exp(law.log_central(log_stiffness + LineLaw::kExponent * std::log(e), u));
      const double approach = e - film;
      const auto found = root(approach, u);
      EXPECT_NEAR(found.value, e, kRoundOff * (e + film)) << e << " m, " << speed << " m/s";
      const double step = 1e-5 * e, du = 1e-5 * std::min(1.0, e / film);
      const auto up = root(approach + step, u), down = root(approach - step, u);
      EXPECT_NEAR((up.value - down.value) / (2.0 * step), found.by_approach,
                  kDifferenceError + kSearchError * (film + e) / step);
      const auto faster = root(approach, u + du), slower = root(approach, u - du);
      EXPECT_NEAR((faster.value - slower.value) / (2.0 * du), found.by_log_speed,
                  kDifferenceError * film + kSearchError * (film + e) / du);
    }
  const double apart = -1.01 * std::exp(law.log_unloaded(0.0));
  EXPECT_LT(root(apart, 0.0).value, 0.0);
}

TEST(ElasticApproach, IsFoundWithTheFilmLaw) {
  check_search(FilmLaw<double>::of(oiled_contact()));
}

TEST(ElasticApproach, IsFoundWithAFilmThatIsNoPowerLaw) {
  check_search(SmoothFilm{FilmLaw<double>::of(oiled_contact())});
}

// The faster search for a film that is a power law gives the same result.
TEST(ElasticApproach, OfPowersIsThatOfAnyFilm) {
  using namespace vectorised::film_law_test_packs;
  const auto law = FilmLaw<double>::of(oiled_contact());
  const double log_stiffness = std::log(8e8);
  vectorised::RaceConstants one;
  one.film = true;
  one.stiffness = 8e8;
  one.log_stiffness = log_stiffness;
  one.film_law = law;
  vectorised::set_film_powers(one);
  vectorised::Constants constants;
  constants.inner = constants.outer = one;
  const RacePair race = race_pair(constants);
  std::mt19937 engine(20251122);
  std::uniform_real_distribution<double> log_approach(-20.0, -7.0), log_speed(-5.0, 4.5), side(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double u = log_speed(engine);
    const double cap = std::exp(law.log_unloaded(u));
    const double approach = side(engine) < -0.5 ? 1.1 * cap * side(engine) : std::exp(log_approach(engine));
    const PackPair a = spread<PackPair>(approach), s = spread<PackPair>(u);
    const PackApproach powers = power_film_approach<true>(race, a, s), any = any_film_approach(race, a, s);
    const auto same = [&](const PackPair& x, const PackPair& y, double scale, const char* what) {
      EXPECT_NEAR(x.low.low[0], y.low.low[0], kRoundOff * scale)
          << what << " at " << approach << " m, " << u << " of ln speed";
    };
    const double size = std::abs(approach) + cap;
    same(powers.value, any.value, size, "value");
    if (any.value.low.low[0] <= 0.0) continue;
    // A slope near the crossing of both films is that of either.
    const double e_cap =
        std::exp(LineLaw::kApproachExponent * (law.log_cap_load + law.kCapLoadSpeed * u - log_stiffness));
    if (std::abs(any.value.low.low[0] / e_cap - 1.0) < 1e-9) continue;
    const double loss = size / any.value.low.low[0];  // digits of the elastic approach cancelled in e - h
    same(powers.by_approach, any.by_approach, loss, "by approach");
    same(powers.by_log_speed, any.by_log_speed, loss * size, "by log speed");
    same(powers.ninth, any.ninth, loss, "ninth root");
  }
}

// Functions of packs for the squeeze film (contact/rigid_line_film.hpp).
TEST(PackFunctions, AngleOfAVector) {
  namespace packs = mechanics::film_law_test_packs;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  const auto worst = [&](double y, double x) {
    const double found = packs::angle_of(packs::spread<packs::Pack>(y), packs::spread<packs::Pack>(x)).low[0];
    const double expected = std::atan2(y, x);
    EXPECT_NEAR(found, expected, 5e-16 * std::max(expected, 0.0) + 1e-300) << y << ' ' << x;
  };
  for (int i = 0; i < 20000; ++i)
    worst(std::pow(10.0, 6.0 * draw(random)), draw(random) * std::pow(10.0, 6.0 * draw(random)));
  worst(1.0, 0.0);
  worst(1.0, -0.0);
  worst(1.0, 1.0);
  worst(1.0, -1.0);
}

}  // namespace
}  // namespace orbearing::bearing::film_law_test
