// One bearing under a static load: displacement, contact loads and standard lives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "coupling/analysis/ball_films.hpp"
#include "coupling/analysis/bearing_friction.hpp"
#include "coupling/analysis/life_table.hpp"
#include "coupling/analysis/single_bearing.hpp"

namespace orbearing::analysis {

/// Range of one result, in the unit that its name ends in, over the positions of the cage in a pitch.
struct PositionRange {
  std::string result;
  double least = 0.0, most = 0.0;
};

/// Results; lives in revolutions, infinite where nothing is loaded.
struct BearingUnderLoad {
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
  std::optional<BearingFriction> rolling_friction;           // none without speed and oil
  std::optional<FrictionByStandards> friction_by_standards;  // none without boundary dimensions
  std::vector<PositionRange> over_positions;                 // of results at the stated position
  std::vector<std::string> warnings;

  BearingLives all_lives() const { return {lives, lundberg_palmgren.bearing, speed, state.largest_pressure}; }
  LifeTable life_table() const;
};

void describe(described::Record& record, const BearingUnderLoad& result);

/// Throws NoResult where no equilibrium is found.
BearingUnderLoad rollers_under_load(const RollersUnderLoad& in);
BearingUnderLoad balls_under_load(const BallsUnderLoad& in);

/// Quantities that follow from the inputs, of rollers or balls.
struct BearingQuantities {
  bearing::rating::Ratings ratings;
  StatedCapacities stated;                            // which are no results
  std::optional<bearing::rating::RatingLives> lives;  // of the load on the bearing alone; none: no P
  bool has_static_load = false;
  double speed = 0.0;                                         // [rad/s]  of the rings against each other
  std::optional<double> groove_distance, free_contact_angle;  // [m], [rad]  of balls
};
void describe(described::Record& record, const BearingQuantities& of);

/// Throws std::invalid_argument where kappa is below the range of a_ISO.
BearingQuantities quantities_of(const RollerBearing& machine);
BearingQuantities quantities_of(const BallBearing& machine);

}  // namespace orbearing::analysis
