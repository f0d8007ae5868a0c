// How lightly a planet bearing is loaded: drag of its oil against the traction of its loaded rollers.
#pragma once

#include <optional>

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// Slip [-] by drag (bearing/motion/drag_slip.hpp) under the loads at rest; none where traction has no closed
/// form, or the bearing at rest no balance.
std::optional<double> slip_by_drag(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                   const BearingDuty& duty);

}  // namespace orbearing::study
