#include "bearing/film/film_choice.hpp"

#include <cmath>
#include <limits>

namespace orbearing::bearing::film {

PointFilmCase point_film_case(const EllipticalContact& contact, const Lubricant& oil,
                              const ContactMotion& motion) {
  PointFilmCase one;
  set_ellipse(one, contact.rolling_radius, contact.ellipticity);
  one.modulus = contact.modulus;
  one.oil = {.viscosity = oil.viscosity, .pressure_viscosity = oil.pressure_viscosity};
  one.load = motion.load;
  one.rolling = std::abs(motion.rolling);
  one.spin = std::abs(motion.spin);
  return one;
}

LineFilmCase line_film_case(const EllipticalContact& contact, double length, const Lubricant& oil,
                            const ContactMotion& motion) {
  return {.radius = contact.rolling_radius,
          .modulus = contact.modulus,
          .oil = {.viscosity = oil.viscosity, .pressure_viscosity = oil.pressure_viscosity},
          .load = motion.load / length,
          .rolling = std::abs(motion.rolling)};
}

double dowson_higginson(const LineFilmCase& line) {
  const double size = line.modulus * line.radius;
  return 2.65 * std::pow(line.oil.viscosity * line.rolling / size, 0.7) *
         std::pow(line.oil.pressure_viscosity * line.modulus, 0.54) * std::pow(line.load / size, -0.13) *
         line.radius;
}

Films films_of(const PointFilm& solution, const EllipticalContact& contact, const Lubricant& oil,
               const ContactMotion& motion) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Films films = spin_films(contact, oil, motion);
  films.rigid = solution.converged ? solution.approach : kNone;
  films.central = solution.converged ? solution.central : kNone;
  films.least = solution.converged ? solution.least : kNone;
  return films;
}

}  // namespace orbearing::bearing::film
