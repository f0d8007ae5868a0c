// `orbearing run` of the model spin-film.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"

namespace orbearing::app {

/// Runs, writes the folder, prints. Returns the exit code. Throws BadInput.
int run_film_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
