// The analysis of a bearing with scratches: `orbearing run` of the model raceway-defect.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Name of the file of a result folder that holds what `run --json` prints.
inline constexpr const char* defect_file_name = "defect.json";

/// Runs, writes the folder, prints. Returns the exit code. Throws BadInput and ComputationFailed.
int run_defect_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
