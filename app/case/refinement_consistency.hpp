// Do the lists of race waves and roller deviations fit each other and the bearing?
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Tells what does not fit to `mistakes`.
void check_refinements(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
