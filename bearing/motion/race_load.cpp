#include "bearing/motion/race_load.hpp"

#include <cmath>

namespace orbearing::bearing::dynamics {

namespace {

constexpr double kLoadExponent = 10.0 / 9.0;
constexpr double kFilmLoadExponent = 0.13;  // h ~ Q^-0.13
constexpr double kFilmSpeedExponent = 0.7;  // h ~ u^0.7
constexpr double kFilmApproachExponent = kFilmLoadExponent * kLoadExponent;
// Where h ~ u^0.7 Q^-0.13 meets the rigid film ~ u / Q: load, elastic approach and film of that crossing.
constexpr double kCapLoadSpeedExponent = (1.0 - kFilmSpeedExponent) / (1.0 - kFilmLoadExponent);
constexpr double kCapApproachSpeedExponent = kCapLoadSpeedExponent / kLoadExponent;
constexpr double kCapSpeedExponent = kFilmSpeedExponent - kFilmLoadExponent * kCapLoadSpeedExponent;
constexpr int kMaxIterations = 12;
constexpr double kSmallStep =
    1e-5;  // relative: the error of a third-order method after such a step is round-off

// x^(10/9), x > 0: a logarithm and an exponential cost less than a power or two cube roots.
double load_power(double x) {
  return x * std::exp(std::log(x) / 9.0);
}

// x^-(13/90), x > 0.
double negative_power(double x) {
  return std::exp(-kFilmApproachExponent * std::log(x));
}

// Root of e - factor e^-m = approach above the cap, by Halley's method: the left side rises and is concave,
// the cap bounds the film from above and gives the start.
double thinned_approach(double approach, double factor, double cap) {
  constexpr double m = kFilmApproachExponent;
  double e = approach > 2.0 * cap ? approach + factor * negative_power(approach) : approach + cap;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double film = factor * negative_power(e);
    const double residual = e - film - approach;
    const double slope = 1.0 + m * film / e;
    const double half_curvature = -0.5 * m * (m + 1.0) * film / (e * e);
    const double step = -residual * slope / (slope * slope - residual * half_curvature);
    e += step;
    if (std::abs(step) <= kSmallStep * e) break;
  }
  return e;
}

}  // namespace

RaceLoadLaw::RaceLoadLaw(LineContact elastic, const FilmContact& contact)
    : elastic_(elastic), with_film_(contact.lubricant.viscosity > 0.0) {
  if (!with_film_) return;
  const Film film(contact, 1.0);
  cap_ = film.cap();
  cap_approach_ = elastic.approach(film.cap_load());
  factor_ = cap_ * std::pow(cap_approach_, kFilmApproachExponent);
}

RaceLoadLaw::FilmScale RaceLoadLaw::film_scale(double entrainment) const {
  const double logarithm = std::log(entrainment);
  return {factor_ * std::exp(kFilmSpeedExponent * logarithm), cap_ * std::exp(kCapSpeedExponent * logarithm),
          cap_approach_ * std::exp(kCapApproachSpeedExponent * logarithm)};
}

double RaceLoadLaw::elastic_approach(double approach, double entrainment) const {
  if (!with_film_) return approach;
  const FilmScale film = film_scale(entrainment);
  if (approach + film.cap <= film.cap_approach) return approach + film.cap;
  return thinned_approach(approach, film.factor, film.cap);
}

double RaceLoadLaw::load(double approach, double entrainment) const {
  const double elastic = elastic_approach(approach, entrainment);
  return elastic > 0.0 ? elastic_.constant() * load_power(elastic) : 0.0;
}

double RaceLoadLaw::energy(double approach, double entrainment) const {
  const double elastic = elastic_approach(approach, entrainment);
  if (elastic <= 0.0) return 0.0;
  const double elastic_energy = elastic_.energy(elastic);
  if (!with_film_) return elastic_energy;
  const FilmScale film = film_scale(entrainment);
  if (elastic <= film.cap_approach) return elastic_energy;
  const double thinned =
      (elastic - approach) * elastic_.load(elastic) - film.cap * elastic_.load(film.cap_approach);
  return elastic_energy + kFilmLoadExponent / (1.0 - kFilmLoadExponent) * thinned;
}

// The energy is Q delta less the integral of delta(Q, u) over Q, so that its slope at constant approach is
// the integral of the film's slope dh/du over the load, in the cap and beyond it.
double RaceLoadLaw::energy_slope(double approach, double entrainment) const {
  const double elastic = elastic_approach(approach, entrainment);
  if (elastic <= 0.0 || !with_film_) return 0.0;
  const FilmScale film = film_scale(entrainment);
  const double load = elastic_.load(elastic);
  if (elastic <= film.cap_approach) return kCapSpeedExponent * film.cap * load / entrainment;
  const double at_cap = film.cap * elastic_.load(film.cap_approach);
  const double thinned = (elastic - approach) * load - at_cap;
  return (kCapSpeedExponent * at_cap + kFilmSpeedExponent / (1.0 - kFilmLoadExponent) * thinned) /
         entrainment;
}

}  // namespace orbearing::bearing::dynamics
