#include "benchmarks/frozen/contact.hpp"

namespace orbearing::bench::frozen {

namespace {

constexpr double kLoadExponent = 10.0 / 9.0;
constexpr double kFilmLoadExponent = 0.13;  // h ~ Q^-0.13
constexpr double kFilmSpeedExponent = 0.7;  // h ~ u^0.7
constexpr double kFilmApproachExponent = kFilmLoadExponent * kLoadExponent;
// Intersection of h ~ u^0.7 Q^-0.13 with the rigid film ~ u / Q: load, elastic approach and film there.
constexpr double kCapLoadSpeedExponent = (1.0 - kFilmSpeedExponent) / (1.0 - kFilmLoadExponent);
constexpr double kCapApproachSpeedExponent = kCapLoadSpeedExponent / kLoadExponent;
constexpr double kCapSpeedExponent = kFilmSpeedExponent - kFilmLoadExponent * kCapLoadSpeedExponent;
constexpr int kMaxIterations = 12;
constexpr double kSmallStep = 1e-5;  // relative: the error of a third-order method after it is round-off

constexpr double kRollingSpeedExponent = 0.658;
constexpr double kRollingLoadExponent = 0.0126;
constexpr double kRollingLoadScale = 1.0;  // [N]

// x^(10/9), x > 0.
double load_power(double x) {
  return x * std::exp(std::log(x) / 9.0);
}

// x^-(13/90), x > 0.
double negative_power(double x) {
  return std::exp(-kFilmApproachExponent * std::log(x));
}

// Root of e - factor e^-m = approach above the cap, by Halley's method.
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

// Central film at 1 m/s: 4/3 of Dowson-Higginson's least one, held where the rigid film takes over.
RaceLoadLaw::RaceLoadLaw(const OiledLine& line) : stiffness_(line.stiffness) {
  const double film = 4.0 / 3.0 * 2.65 * std::pow(line.pressure_viscosity, 0.54) *
                      std::pow(line.viscosity, kFilmSpeedExponent) * std::pow(line.equivalent_radius, 0.43) /
                      std::pow(line.reduced_modulus, 0.03) * std::pow(line.length, kFilmLoadExponent);
  const double rigid = 4.896 * line.viscosity * line.equivalent_radius * line.length;
  const double cap_load = std::pow(rigid / film, 1.0 / (1.0 - kFilmLoadExponent));
  cap_ = film * std::pow(cap_load, -kFilmLoadExponent);
  cap_approach_ = std::pow(cap_load / stiffness_, 1.0 / kLoadExponent);
  factor_ = cap_ * std::pow(cap_approach_, kFilmApproachExponent);
}

RaceLoadLaw::FilmScale RaceLoadLaw::film_scale(double entrainment) const {
  const double logarithm = std::log(entrainment);
  return {factor_ * std::exp(kFilmSpeedExponent * logarithm), cap_ * std::exp(kCapSpeedExponent * logarithm),
          cap_approach_ * std::exp(kCapApproachSpeedExponent * logarithm)};
}

double RaceLoadLaw::elastic_approach(double approach, double entrainment) const {
  const FilmScale film = film_scale(entrainment);
  if (approach + film.cap <= film.cap_approach) return approach + film.cap;
  return thinned_approach(approach, film.factor, film.cap);
}

double RaceLoadLaw::load(double approach, double entrainment) const {
  const double elastic = elastic_approach(approach, entrainment);
  return elastic > 0.0 ? stiffness_ * load_power(elastic) : 0.0;
}

RollingResistance::RollingResistance(const OiledLine& line) {
  const double area = line.equivalent_radius * line.length;
  factor_ =
      4.318 *
      std::pow(line.pressure_viscosity * line.viscosity / line.equivalent_radius, kRollingSpeedExponent) *
      std::pow(line.reduced_modulus * area, -kRollingLoadExponent) * area / line.pressure_viscosity;
}

double RollingResistance::force(double load, double rolling, double entrainment) const {
  if (load <= 0.0 || factor_ <= 0.0) return 0.0;
  const double powers =
      std::exp(kRollingSpeedExponent * std::log(entrainment) + kRollingLoadExponent * std::log(load));
  return factor_ * powers * (load / (load + kRollingLoadScale)) * (rolling / entrainment);
}

}  // namespace orbearing::bench::frozen
