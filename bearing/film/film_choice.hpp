// How the film of one contact is found: by regressions, or by Reynolds' equation itself.
#pragma once

#include <optional>

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

struct FilmChoice {
  FilmSolver solver = FilmSolver::regression;
};

template <class Visitor>
void describe(Visitor& visit, FilmChoice& m) {
  using namespace described;
  members(
      visit, m,
      field(
          m.solver, "film.solver", Felt::one_contact,
          "film by the source's regressions, or by Reynolds' equation with elastic bodies (129 x 129 nodes)",
          {.models = spin_film,
           .reason = "as the source; a solution takes about a second and has no range to leave"}));
}

/// The contact and motion as Reynolds' equation takes them; directions do not matter, so sizes alone.
PointFilmCase point_film_case(const EllipticalContact& contact, const Lubricant& oil,
                              const ContactMotion& motion);

/// Films by Reynolds' equation; those of Hamrock and Dowson beside them. Not a number where it was not
/// solved.
Films films_of(const PointFilm& solution, const EllipticalContact& contact, const Lubricant& oil,
               const ContactMotion& motion);

}  // namespace orbearing::bearing::film
