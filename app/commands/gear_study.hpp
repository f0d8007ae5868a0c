// The analysis of a planetary set without bearing dynamics: `orbearing run` of a case without a bearing.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Whether `run` of this case is that of its gears.
bool runs_gears_alone(const ResolvedCase& resolved);

/// Runs, writes the folder, prints. Returns the exit code. Throws BadInput and ComputationFailed.
int run_gear_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
