#include "bearing/contact/race_contact.hpp"

#include <cmath>

namespace orbearing::bearing {

FilmContact film_contact(const Bearing& bearing, const BearingGeometry& geometry, Race race,
                         const Lubricant& lubricant) {
  const Material& steel = bearing.material;
  return {.equivalent_radius = equivalent_radius(geometry, race),
          .length = bearing.rollers().length,
          .reduced_modulus = steel.plane_strain_modulus(),
          .lubricant = lubricant};
}

Film::Film(const FilmContact& contact, double entrainment_speed)
    : oiled_(contact.lubricant.viscosity > 0.0 && contact.lubricant.pressure_viscosity > 0.0 &&
             entrainment_speed > 0.0) {
  if (!oiled_) return;
  law_ = FilmLaw<double>::of(contact);
  log_speed_ = std::log(entrainment_speed);
  cap_load_ = std::exp(law_.log_cap_load + law_.kCapLoadSpeed * log_speed_);
  cap_ = std::exp(law_.log_unloaded(log_speed_));
}

double Film::central(double load) const {
  return loaded(load) ? std::exp(law_.log_central(std::log(load), log_speed_)) : cap_;
}

double Film::slope(double load) const {
  if (!loaded(load)) return 0.0;
  return exponential(law_.log_central(logarithm(mechanics::variable<0>(load)), log_speed_)).by<0>();
}

double Film::least(double load) const {
  return central(load) / law_.kCentralOverLeast;
}

double Film::energy(double load) const {
  return loaded(load) ? law_.energy(load, log_speed_) : 0.0;
}

RollerContacts rolling_contacts(const Bearing& bearing, const BearingGeometry& geometry, double inner_speed,
                                double outer_speed, const std::optional<Lubricant>& lubricant) {
  const LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  if (!lubricant) return {{elastic, Film()}, {elastic, Film()}};
  const double cage_speed = kinematic_cage_speed(geometry, inner_speed, outer_speed);
  return {{elastic, Film(film_contact(bearing, geometry, Race::inner, *lubricant),
                         std::abs((inner_speed - cage_speed) * geometry.inner_radius))},
          {elastic, Film(film_contact(bearing, geometry, Race::outer, *lubricant),
                         std::abs((outer_speed - cage_speed) * geometry.outer_radius))}};
}

}  // namespace orbearing::bearing
