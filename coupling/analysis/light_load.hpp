// Estimates of the motion of a planet bearing from its load at rest: slip under light load, and required
// accuracy of the roller motion.
#pragma once

#include <optional>
#include <vector>

#include "coupling/analysis/drivetrain.hpp"

namespace orbearing::analysis {

/// Means of one bearing of each duty, at rest, where rollers are equal and no wave turns; none without an
/// equilibrium.
using MeansAtRest = std::vector<std::optional<bearing::motion::WindowStatistics>>;
MeansAtRest means_at_rest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const std::vector<BearingDuty>& duties);

/// Drag over traction [-] (bearing/motion/drag_slip.hpp) under the loads at rest; none where traction is not
/// that of the surfaces only, or the bearing at rest has no equilibrium.
std::optional<double> drag_over_traction(const PlanetaryDrivetrain& drivetrain,
                                         const DrivetrainGeometry& geometry, const BearingDuty& duty,
                                         const std::optional<bearing::motion::WindowStatistics>& at_rest);

/// Slip [-] of the cage by the same source; none also without an equilibrium of the cage, or without a cage.
std::optional<double> slip_by_drag(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                   const BearingDuty& duty,
                                   const std::optional<bearing::motion::WindowStatistics>& at_rest);

/// With the error of a step that follows the load: a share of the elastic approach of the most loaded roller
/// at rest, on the planet where that is least. Unchanged if that share is 0, or a bearing has no equilibrium.
PlanetaryDrivetrain with_error_of_load(PlanetaryDrivetrain drivetrain, const MeansAtRest& at_rest);

}  // namespace orbearing::analysis
