// Films of a contact that rolls and spins, by the regressions of bearing/film or by Reynolds' equation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/film/film_choice.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Central film of a line, over a step of its grid squared, below which the grid does not tell it: its least
/// film is some tenths too thin there.
inline constexpr double kLeastFilmInSteps = 60.0;

struct FilmPoint {
  bearing::film::ContactMotion motion;
  bearing::film::Films films;
  std::optional<bearing::film::PointFilm> solution{};  // of Reynolds' equation
  std::optional<bearing::film::LineFilm> line{};       // the same of a line contact, which has nothing else
  double length = 0.0;                                 // [m]  of that contact
  double least_dowson_higginson = 0.0;                 // [m]  of it

  /// Whether Reynolds' equation was asked for and not solved.
  bool lost() const {
    return (solution && !solution->converged) ||
           (line && (!line->converged || line->film_in_steps < kLeastFilmInSteps));
  }
};

/// Its motion and films; nothing where it is not loaded.
void describe(described::Record& row, const FilmPoint& point);

struct FilmStudy {
  std::vector<FilmPoint> points;
  std::vector<std::string> warnings;  // what lies outside of the ranges of the regressions, or was not solved
};

/// With pressure and film at each node of the solutions of Reynolds' equation.
void describe(described::Record& record, const FilmStudy& study);

/// Whether a case is that of a contact by itself.
bool is_spin_film(const ResolvedCase& resolved);

FilmStudy film_study(const ResolvedCase& resolved);

}  // namespace orbearing::app
