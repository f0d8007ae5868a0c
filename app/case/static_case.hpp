// Cases of the models roller-bearing and ball-bearing: one bearing under a load of its own, at rest or in
// time.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/ball_run.hpp"
#include "coupling/analysis/bearing_under_load.hpp"

namespace orbearing::app {

/// Whether a case is that of one bearing under a static load.
bool is_static_bearing(const ResolvedCase& resolved);
/// Whether a case is that of a ball bearing in time.
bool is_ball_run(const ResolvedCase& resolved);

/// Throws ComputationFailed where no equilibrium is found, BadInput for another model.
analysis::BearingUnderLoad bearing_under_load(const ResolvedCase& resolved);
/// `progress` gets the share done [-], if any. Throws ComputationFailed where the run ends early.
analysis::BallRun ball_run(const ResolvedCase& resolved, const std::function<void(double)>& progress = {});

}  // namespace orbearing::app
