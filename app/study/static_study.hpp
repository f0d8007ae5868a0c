// One bearing under a static load: displacement, contact loads and standard lives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/results/life_table.hpp"
#include "app/study/film_study.hpp"
#include "app/study/friction_study.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/ring_balance.hpp"

namespace orbearing::app {

// Results of one bearing under a static load.

/// Range of one result, in the unit that its name ends in, over the positions of the cage in a pitch.
struct PositionRange {
  std::string result;
  double least = 0.0, most = 0.0;
};

/// Results; lives in revolutions, infinite where nothing is loaded.
struct StaticStudy {
  bearing::Bearing bearing;
  bearing::equilibrium::RingState state;
  double radial = 0.0;  // [m]    displacement across the axis, of both planes
  double tilt = 0.0;    // [rad]  of both planes
  bearing::rating::Ratings ratings;
  bearing::rating::RatingLives lives;           // by the standards
  bearing::BearingLife lundberg_palmgren;       // [rev]
  double reduction_factor = 0.0;                // [-]      in its capacities; of rollers
  bearing::rating::StressRiser stress_riser{};  // of L10r; of rollers
  bearing::rating::Life governing{};
  double speed = 0.0;                          // [rad/s]  of the rings against each other; 0: not known
  std::optional<std::vector<BallFilm>> films;  // of balls whose film takes part
  std::optional<bearing::defect::PassingFrequencies> passing;  // at pure rolling; none without a speed
  std::optional<SpeedTable> over_speed;
  std::optional<FrictionStudy> rolling_friction;             // none without speed and oil
  std::optional<FrictionByStandards> friction_by_standards;  // none without boundary dimensions
  std::vector<PositionRange> over_positions;                 // of results at the stated position
  std::vector<std::string> warnings;

  BearingLives all_lives() const { return {lives, lundberg_palmgren.bearing, speed, state.largest_pressure}; }
  LifeTable life_table() const;
};

void describe(described::Record& record, const StaticStudy& study);

// Factors of the life of the bearing of a case, and its ratings for `orbearing check`.

/// P, P_0, oil and a_1 of a single bearing, quasi-static or in time. Throws BadInput where kappa is below the
/// range of a_ISO.
bearing::rating::RatingCondition rating_condition_of(const ResolvedCase& resolved,
                                                     const bearing::Bearing& bearing);

/// Quantities derived from the inputs, for `orbearing check`.
std::vector<Derived> static_quantities(const ResolvedCase& resolved);

/// Whether a case is that of one bearing under a static load.
bool is_static_bearing(const ResolvedCase& resolved);

/// Throws ComputationFailed where no equilibrium is found, BadInput for another model.
StaticStudy static_study(const ResolvedCase& resolved);

}  // namespace orbearing::app
