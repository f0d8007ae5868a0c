// The analysis of one bearing under a static load: `orbearing run` of the models roller-bearing and
// ball-bearing.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Runs, writes the folder, prints. Returns the exit code. Throws BadInput and ComputationFailed.
int run_static_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
