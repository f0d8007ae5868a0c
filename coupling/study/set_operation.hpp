// Speeds and torques of the members of a set, whether it is single or one of several.
#pragma once

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// Of the dynamics and the static balance of the set's gears. In an arrangement all torques are stated, and
/// none follows from the power.
/// @throws std::invalid_argument as gearset::mean_loads()
gearset::dynamics::Operation set_operation(const PlanetaryDrivetrain& drivetrain,
                                           const gearset::WorkingGeometry& gears);

}  // namespace orbearing::study
