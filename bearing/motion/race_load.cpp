#include "bearing/motion/race_load.hpp"

#include <cmath>

namespace orbearing::bearing::motion {

RaceLoadLaw::RaceLoadLaw(LineContact elastic, const FilmContact& contact)
    : elastic_(elastic),
      with_film_(contact.lubricant.viscosity > 0.0),
      film_(FilmLaw<double>::of(contact)),
      log_stiffness_(std::log(elastic.constant())) {}

double RaceLoadLaw::elastic_approach(double approach, double entrainment) const {
  if (!with_film_) return approach;
  return bearing::elastic_approach(film_, log_stiffness_, approach, std::log(entrainment)).value;
}

double RaceLoadLaw::load(double approach, double entrainment) const {
  return elastic_.load(elastic_approach(approach, entrainment));
}

double RaceLoadLaw::energy(double approach, double entrainment) const {
  const double elastic = elastic_approach(approach, entrainment);
  if (elastic <= 0.0) return 0.0;
  const double elastic_energy = elastic_.energy(elastic);
  if (!with_film_) return elastic_energy;
  return elastic_energy + film_.energy(elastic_.load(elastic), std::log(entrainment));
}

// The energy is Q delta less the integral of delta(Q, u) over Q, so that its slope at constant approach is
// that of the integral of the film over the load.
double RaceLoadLaw::energy_slope(double approach, double entrainment) const {
  const double elastic = elastic_approach(approach, entrainment);
  if (elastic <= 0.0 || !with_film_) return 0.0;
  const auto log_speed = logarithm(mechanics::variable<0>(entrainment));
  return film_integral(film_, elastic_.load(elastic), log_speed).by<0>();
}

}  // namespace orbearing::bearing::motion
