// The analyses of a duplex pair: `orbearing modes` and `orbearing run` of the model duplex-pair.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Both print, `run` writes the folder. Return the exit code. Throw BadInput and ComputationFailed.
int duplex_modes(const ResolvedCase& resolved, const Options& options);
int run_duplex_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
