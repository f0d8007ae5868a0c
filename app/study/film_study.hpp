// Films of a contact that rolls and spins, by the regressions of bearing/film or by Reynolds' equation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
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

// Films under the balls of a bearing in balance, and its balance over speed, with films and with Hertz's law.

/// Of one ball on one race.
struct BallFilm {
  Eigen::Index ball = 0;
  bearing::Race race = bearing::Race::inner;
  FilmPoint point;  // sizes of speed and spin, whatever their sense
};

void describe(described::Record& row, const BallFilm& film);

/// Of all loaded balls of a state whose rings turn, inner race first; empty for one at rest.
std::vector<BallFilm> ball_films(const bearing::Bearing& bearing, const bearing::Lubricant& oil,
                                 const bearing::equilibrium::RingState& state);

/// What of them lies outside of the ranges of the regressions, one line for each race and quantity.
std::vector<std::string> film_warnings(const bearing::Bearing& bearing, const std::vector<BallFilm>& films);

/// The ball with the largest load on the inner race, over the speed of the inner ring.
struct SpeedTable {
  std::vector<described::Record>
      rows;  // numbers in the unit that ends their name; absent where there is none
  std::optional<double>
      inner_rotating;  // [rad/s]  speed of the largest least film, none where the table ends first
  std::optional<double> outer_rotating;
  std::vector<std::string> warnings;
};

void describe(described::Record& record, const SpeedTable& table);

/// At `operation.speeds`; none where the case has none. With film and without where `film.enabled` says so.
/// A speed at which no balance is found has no numbers, and a warning.
std::optional<SpeedTable> speed_table(const ResolvedCase& resolved);

}  // namespace orbearing::app
