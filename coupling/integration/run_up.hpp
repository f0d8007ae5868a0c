// A planet bearing whose speeds change: from the steady state, with growing or falling speed at constant
// power.
#pragma once

#include "coupling/integration/steady_state.hpp"

namespace orbearing::integration {

/// Runs `bearing` at `point` until it is steady, as run_to_steady_state() does, then lets all speeds grow by
/// `parameters.driving.growth` for `duration` [s]. Means, series (options.series_samples over the whole
/// run-up) and slip are those of the run-up; its time counts from its beginning, the cage's slip refers to
/// the mean speed. Throws std::invalid_argument where the duration is not positive or the speeds would come
/// to rest.
SteadyStateResult run_up(const bearing::CylindricalRollerBearing& bearing,
                         const bearing::OperatingPoint& point,
                         const bearing::dynamics::DynamicsParameters& parameters,
                         const SteadyStateOptions& options, double duration);

}  // namespace orbearing::integration
