// Method for the film of one contact: regressions, or Reynolds' equation itself.
#pragma once

#include <optional>

#include "bearing/film/reynolds/line.hpp"
#include "bearing/film/reynolds/point.hpp"
#include "bearing/film/spin_film.hpp"

namespace orbearing::bearing::film {

enum class FilmSolver {
  regression,  // spin_films()
  reynolds,    // solve_point_film()
};

constexpr described::Names<FilmSolver, 2> names_of(FilmSolver) {
  return {{{FilmSolver::regression, "regression"}, {FilmSolver::reynolds, "reynolds"}}};
}

/// The same of a line contact of `length` [m].
LineFilmCase line_film_case(const EllipticalContact& contact, double length, const Lubricant& oil,
                            const ContactMotion& motion);

/// Least film [m] of a line contact, 2.65 U^0.7 G^0.54 W^-0.13 R [DowsonHigginson1966].
double dowson_higginson(const LineFilmCase& line);

/// The contact and motion in the form for Reynolds' equation; directions do not matter, so magnitudes only.
PointFilmCase point_film_case(const EllipticalContact& contact, const Lubricant& oil,
                              const ContactMotion& motion);

/// Films by Reynolds' equation; those of Hamrock and Dowson for comparison. Not a number where it was not
/// solved.
Films films_of(const PointFilm& solution, const EllipticalContact& contact, const Lubricant& oil,
               const ContactMotion& motion);

}  // namespace orbearing::bearing::film
