// Films of a contact that rolls and spins, by the regressions of bearing/film or by Reynolds' equation.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/point_content.hpp"
#include "bearing/film/film_choice.hpp"

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

struct FilmStudy {
  std::vector<FilmPoint> points;
  std::vector<std::string> warnings;  // what lies outside of the ranges of the regressions, or was not solved
};

/// Whether a case is that of a contact by itself.
bool is_spin_film(const ResolvedCase& resolved);

FilmStudy film_study(const ResolvedCase& resolved);

/// Of the first point, by its name in the results: "h_c_um", "h_min_um", "h_c_HamrockDowson_um",
/// "h_min_HamrockDowson_um", "h_0_um", of lines "h_flow_um", "h_min_DowsonHigginson_um" and
/// "rolling_resistance_N"; NaN for a name that is not known.
double film_property(const FilmStudy& study, const std::string& quantity);

/// load_N, rolling_speed_m_s, spin_rad_s and the films in um; null where nothing is loaded.
nlohmann::ordered_json film_json(const FilmPoint& point);
nlohmann::ordered_json film_json(const FilmStudy& study);
std::string film_text(const FilmStudy& study);
PointContent film_content(const FilmStudy& study);
/// The same as rows of text.
std::string film_csv(const FilmStudy& study);
/// Pressure and film at each node of a solution of Reynolds' equation, as rows of text.
std::string film_map_csv(const bearing::film::PointFilm& solution);
std::string film_line_csv(const bearing::film::LineFilm& solution);

}  // namespace orbearing::app
