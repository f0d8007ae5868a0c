// The analysis of a gear set with a scratched planet bearing: `orbearing run` of a planetary drivetrain with a block
// `defect`.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Runs, writes the folder, prints. Returns the exit code. Throws BadInput and ComputationFailed.
int run_planet_defect_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
