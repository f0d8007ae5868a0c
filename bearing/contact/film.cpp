#include "bearing/contact/film.hpp"

#include <cmath>

namespace orbearing::bearing {

namespace {
constexpr double kFilmLoadExponent = 0.13;
constexpr double kCentralOverLeast = 4.0 / 3.0;

// Eq. (10) of [Gai2025] without its load, times 4/3 and with q = Q/l.
double central_factor(const FilmContact& contact, double speed) {
  const double alpha = contact.lubricant.pressure_viscosity;
  const double eta = contact.lubricant.viscosity;
  const double least = 2.65 * std::pow(alpha, 0.54) * std::pow(eta * speed, 0.7) *
                       std::pow(contact.equivalent_radius, 0.43) / std::pow(contact.reduced_modulus, 0.03);
  return kCentralOverLeast * least * std::pow(contact.length, kFilmLoadExponent);
}
}  // namespace

FilmContact film_contact(const CylindricalRollerBearing& bearing, const RollerBearingGeometry& geometry,
                         Race race, const Lubricant& lubricant) {
  const Material& steel = bearing.material;
  return {.equivalent_radius = equivalent_radius(geometry, race),
          .length = bearing.roller_length,
          .reduced_modulus = steel.plane_strain_modulus(),
          .lubricant = lubricant};
}

Film::Film(const FilmContact& contact, double entrainment_speed)
    : factor_(central_factor(contact, entrainment_speed)) {
  if (factor_ <= 0.0) return;
  const double rigid =
      4.896 * contact.lubricant.viscosity * entrainment_speed * contact.equivalent_radius * contact.length;
  cap_load_ = std::pow(rigid / factor_, 1.0 / (1.0 - kFilmLoadExponent));
  cap_ = factor_ * std::pow(cap_load_, -kFilmLoadExponent);
}

double Film::central(double load) const {
  return load > cap_load_ ? factor_ * std::pow(load, -kFilmLoadExponent) : cap_;
}

double Film::slope(double load) const {
  return load > cap_load_ ? -kFilmLoadExponent * factor_ * std::pow(load, -kFilmLoadExponent - 1.0) : 0.0;
}

double Film::least(double load) const {
  return central(load) / kCentralOverLeast;
}

double Film::energy(double load) const {
  if (load <= cap_load_) return 0.0;
  const double exponent = 1.0 - kFilmLoadExponent;
  return kFilmLoadExponent / exponent * factor_ * (std::pow(load, exponent) - std::pow(cap_load_, exponent));
}

}  // namespace orbearing::bearing
