// From what the user states to the laws of one race.
#pragma once

#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/motion/race_forces.hpp"

namespace orbearing::bearing::motion {

/// Laws of `race`. `point` gives the film that is subtracted where the source's printed approach is asked
/// for.
RaceModel race_model(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                     Race race, const DynamicsParameters& parameters);

}  // namespace orbearing::bearing::motion
