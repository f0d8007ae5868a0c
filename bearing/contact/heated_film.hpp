// Shear heats the oil before a line contact, so that the film is thinner than the isothermal one, more so
// where the surfaces slide.
//
//   h/h_isothermal = (1 - 13.2 (p_H/E') L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64),   L = beta eta u^2/k
//
// [Gupta1992], from memory. p_H: pressure of Hertz, E' = E/(1 - nu^2), S = |u_1 - u_2|/u, u: mean speed of
// both surfaces, beta: relative fall of the viscosity per kelvin, k: conductivity of the oil.
#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/contact/race_contact.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

/// Share [-] of the isothermal film at the thermal loading L, at least 0.
inline double heated_film_share(double loading, double pressure_over_modulus, double slide_to_roll) {
  const double squashed = 1.0 - 13.2 * pressure_over_modulus * std::pow(loading, 0.42);
  return std::max(0.0, squashed) /
         (1.0 + 0.213 * (1.0 + 2.23 * std::pow(slide_to_roll, 0.83)) * std::pow(loading, 0.64));
}

/// Heating of the film as far as it does not depend on the motion.
struct FilmHeating {
  double loading = 0.0;  // [s^2/m^2]  beta eta/k; 0: isothermal

  /// Parameters are motion::RaceContactParameters.
  template <class Parameters>
  static FilmHeating of(const Parameters& given, const Lubricant& oil) {
    using Heating = decltype(given.film_heating);
    if (given.film_heating == Heating::none) return {};
    return {given.viscosity_slope * oil.viscosity / given.oil_conductivity};
  }

  /// Share [-] of the film under `load` [N] at these speeds [m/s].
  double share(const FilmContact& contact, double load, double entrainment, double sliding = 0.0) const {
    if (!(loading > 0.0) || !(entrainment > 0.0)) return 1.0;
    const double pressure = std::sqrt(std::max(0.0, load) * contact.reduced_modulus /
                                      (2.0 * constants::pi * contact.equivalent_radius * contact.length));
    return heated_film_share(loading * entrainment * entrainment, pressure / contact.reduced_modulus,
                             std::abs(sliding) / entrainment);
  }
};

}  // namespace orbearing::bearing
