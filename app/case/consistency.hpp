// Checks that need several values at once: can the teeth be assembled, do the rollers fit?
#pragma once

#include <string_view>
#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether the value of that path can contradict others.
bool takes_part_in_consistency(std::string_view path);

/// Appends a mistake for each contradiction between values; a check whose values are not all there is left
/// out.
void check_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

/// Appends a mistake for each value of an axis that contradicts the case. Each is checked once, the other
/// axes being at the case's own value where they hold it, else at their first: the sum of the axes' lengths,
/// and points of the sweep only. Axes that `check_consistency` does not check are left out. Of many mistakes
/// of one axis the first are reported and the rest counted.
void check_sweep_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
