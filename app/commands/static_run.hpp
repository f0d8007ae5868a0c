// The analyses of one bearing by itself: `orbearing run` of the models roller-bearing and ball-bearing, under a
// static load or, of balls, in time.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Run, write the folder, print. Return the exit code. Throw BadInput and ComputationFailed.
int run_static_case(const ResolvedCase& resolved, const Options& options);
int run_ball_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
