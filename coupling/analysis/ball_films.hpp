// Films under the balls of a bearing in equilibrium, and its equilibrium over speed, with films and with
// Hertz's law.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/equilibrium/ring_balance.hpp"
#include "coupling/analysis/contact_film.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Film of one ball on one race.
struct BallFilm {
  Eigen::Index ball = 0;
  bearing::Race race = bearing::Race::inner;
  FilmPoint point;  // sizes of speed and spin, whatever their sense
};

void describe(described::Record& row, const BallFilm& film);

/// Films of all loaded balls of a state whose rings rotate, inner race first; empty for a stationary bearing.
std::vector<BallFilm> ball_films(const bearing::Bearing& bearing, const bearing::Lubricant& oil,
                                 const bearing::equilibrium::RingState& state);

/// Warnings on films outside of the ranges of the regressions, one line for each race and quantity.
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

/// At the stated speeds; none where none are stated. With film and without if the film takes part. A speed
/// without equilibrium has no numbers, and a warning.
std::optional<SpeedTable> speed_table(const BallsUnderLoad& in);

}  // namespace orbearing::analysis
