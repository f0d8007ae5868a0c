// The analyses of one bearing by itself: `orbearing run` of the models roller-bearing and ball-bearing, under a
// static load or, of balls, in time.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Name of the file of a result folder that holds what `run --json` prints of a ball bearing in time.
inline constexpr const char* ball_file_name = "ball.json";

/// Run, write the folder, print. Return the exit code. Throw BadInput and ComputationFailed.
int run_static_case(const ResolvedCase& resolved, const Options& options);
int run_ball_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
