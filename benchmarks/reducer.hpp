// The bearing that is timed: a planet bearing of cases/reducer_150kW with film and traction on.
#pragma once

#include "bearing/motion/model.hpp"
#include "coupling/analysis/drivetrain.hpp"

namespace orbearing::bench {

/// One operating point, ready to be run in time.
struct Duty {
  bearing::Bearing bearing;
  bearing::OperatingPoint point;
  bearing::motion::DynamicsParameters parameters;
  double allowed_length_error = 0.0;  // [m]  of one step, as the case has it

  bearing::motion::BearingModel model() const {
    return bearing::motion::bearing_model(bearing, point, parameters);
  }
  /// One revolution of the cage relative to the carrier at pure rolling [s].
  double cage_revolution() const;
};

/// Forces of the gears on the bearing: their mean forces only, or with the variation of the real meshes.
enum class MeshForces { constant, varying };

/// Contacts with squeeze film: none, as in the frozen equations, the races only, or races and bars of the
/// pockets, the complete model.
enum class Squeeze { off, races, races_and_pockets };

/// The shipped case, with the film in the approach. Throws app::BadInput where it cannot be read.
analysis::PlanetaryDrivetrain shipped_reducer(MeshForces meshes = MeshForces::constant,
                                              Squeeze squeeze = Squeeze::races_and_pockets);

/// Duty at the input speed `rpm` [1/min] with diametral clearance `clearance` [um].
Duty duty_at(analysis::PlanetaryDrivetrain drivetrain, double rpm, double clearance);

/// Its contacts cut into `laminae`, the rollers with the standard's profile.
Duty with_laminae(Duty duty, int laminae);

/// The same rollers, `factor` times as many on a pitch circle as much larger, under as much more load.
Duty with_more_rollers(const Duty& duty, int factor);

}  // namespace orbearing::bench
