#include "bearing/life/life_modification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bearing/units.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::rating {

namespace {

// Film in the bracket of a_ISO: numerator and power of kappa.
struct FilmTerm {
  double numerator;
  double power;
};

FilmTerm film_term(RollingElement element, double kappa) {
  const bool ball = element == RollingElement::ball;
  if (kappa < 0.4) return {ball ? 2.2649 : 1.3993, 0.054381};
  return {ball ? 1.9987 : 1.2348, kappa < 1.0 ? 0.19087 : 0.071739};
}

struct CleanlinessTerm {
  double growth;  // b
  double size;    // c
};

CleanlinessTerm oil_term(Lubrication lubrication, Cleanliness cleanliness) {
  constexpr std::array<CleanlinessTerm, 4> filtered{
      {{0.0864, 0.5663}, {0.0432, 0.9987}, {0.0288, 1.6329}, {0.0216, 2.3362}}};
  constexpr std::array<CleanlinessTerm, 5> bath{
      {{0.0864, 0.6796}, {0.0288, 1.141}, {0.0133, 1.67}, {0.00864, 2.5164}, {0.00411, 3.8974}}};
  const auto level = static_cast<std::size_t>(cleanliness);
  if (lubrication == Lubrication::oil_bath) return bath.at(level);
  if (level < filtered.size()) return filtered[level];
  throw std::invalid_argument(
      "contamination: found the lowest cleanliness for circulating oil; required: one of the four filters, "
      "or "
      "an oil bath");
}

CleanlinessTerm grease_term(Cleanliness cleanliness, double pitch_mm) {
  constexpr double large = 500.0;  // [mm]
  constexpr std::array<CleanlinessTerm, 5> grease{
      {{0.0864, 0.6796}, {0.0432, 1.141}, {0.0177, 1.887}, {0.0115, 2.662}, {0.00617, 4.06}}};
  if (cleanliness == Cleanliness::medium && pitch_mm >= large) return {0.0177, 1.677};
  return grease.at(static_cast<std::size_t>(cleanliness));
}

}  // namespace

double required_viscosity(double speed, double pitch_diameter) {
  const double rpm = std::abs(speed) * 30.0 / constants::pi;
  if (!(rpm > 0.0)) mechanics::refuse("viscosity ratio", rpm, "a speed above 0 rpm");
  const double size = 1.0 / std::sqrt(kMillimetres * pitch_diameter);
  const double mm2_per_s =
      rpm < 1000.0 ? 45000.0 * std::pow(rpm, -0.83) * size : 4500.0 * size / std::sqrt(rpm);
  return 1e-6 * mm2_per_s;
}

double fatigue_load_limit(RollingElement element, double static_capacity, double pitch_diameter) {
  const bool ball = element == RollingElement::ball;
  constexpr double large = 0.1;  // [m]
  const double size = std::pow(std::min(1.0, large / pitch_diameter), ball ? 0.5 : 0.3);
  return static_capacity / (ball ? 22.0 : 8.2) * size;
}

double contamination_factor(Lubrication lubrication, Cleanliness cleanliness, double kappa,
                            double pitch_diameter) {
  const double pitch_mm = kMillimetres * pitch_diameter;
  const CleanlinessTerm term = lubrication == Lubrication::grease ? grease_term(cleanliness, pitch_mm)
                                                                  : oil_term(lubrication, cleanliness);
  // std::min and std::max keep a first argument that is not a number.
  const double counted = std::min(kappa, kLargestViscosityRatio);
  const double film = std::min(term.growth * std::pow(counted, 0.68) * std::pow(pitch_mm, 0.55), 1.0);
  return std::max(film * (1.0 - term.size / std::cbrt(pitch_mm)), 0.0);
}

OilCondition oil_condition(const StatedOil& oil, double speed, double pitch_diameter) {
  const double kappa = oil.viscosity_ratio
                           ? *oil.viscosity_ratio
                           : oil.kinematic_viscosity / required_viscosity(speed, pitch_diameter);
  return {kappa, oil.contamination_factor
                     ? *oil.contamination_factor
                     : contamination_factor(oil.lubrication, oil.cleanliness, kappa, pitch_diameter)};
}

double viscosity_ratio_of_film(double least_film, double roughness) {
  return std::pow(least_film / roughness, 1.3);
}

double life_modification_factor(RollingElement element, double kappa, double fatigue_ratio) {
  if (!(kappa >= kLeastViscosityRatio))
    mechanics::refuse("viscosity ratio kappa", kappa, "at least 0.1, where a_ISO begins");
  if (!(fatigue_ratio >= 0.0)) mechanics::refuse("e_C C_u/P", fatigue_ratio, "at least 0");
  const double film = std::min(kappa, kLargestViscosityRatio);
  const FilmTerm term = film_term(element, film);
  const bool ball = element == RollingElement::ball;
  // At kappa = 0.1 the film term vanishes; rounded coefficients leave it a hair below.
  const double left = (ball ? 2.5671 : 1.5859) - term.numerator / std::pow(film, term.power);
  if (!(left > 0.0)) return kLeastLifeModification;
  const double stress =
      ball ? std::pow(left, 0.83) * std::cbrt(fatigue_ratio) : left * std::pow(fatigue_ratio, 0.4);
  if (stress >= 1.0) return kLargestLifeModification;
  return std::min(kLargestLifeModification,
                  kLeastLifeModification * std::pow(1.0 - stress, ball ? -9.3 : -9.185));
}

}  // namespace orbearing::bearing::rating
