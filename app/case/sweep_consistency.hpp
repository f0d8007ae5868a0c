// Do the values of a sweep fit the rest of the case?
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Appends a mistake for each value of an axis that contradicts the case. Each is looked at once, the other
/// axes being at the case's own value where they hold it, else at their first: the sum of the axes'
/// lengths, and points of the sweep only. Axes that `check_consistency` does not look at are left out. Of
/// many mistakes of one axis the first are told and the rest counted.
void check_sweep_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
