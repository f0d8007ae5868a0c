// From what the user states to the laws of one race.
#pragma once

#include "bearing/dynamics/parameters.hpp"
#include "bearing/dynamics/race_forces.hpp"
#include "bearing/quasi_static.hpp"

namespace orbearing::bearing::dynamics {

/// Laws of `race`. `point` gives the film that is subtracted where the source's printed approach is asked
/// for.
RaceModel race_model(const CylindricalRollerBearing& bearing, const OperatingPoint& point, Race race,
                     const DynamicsParameters& parameters);

/// Throws std::invalid_argument "name: found ...; required: ..." unless `holds`.
void require(bool holds, const char* name, double found, const char* required);

}  // namespace orbearing::bearing::dynamics
