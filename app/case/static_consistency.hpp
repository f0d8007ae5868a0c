// Do the values of one bearing under a static load fit each other?
#pragma once

#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Adds what is wrong to `mistakes`; nothing for cases of other models.
void check_static_bearing(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

/// Whether level and manner of lubrication fit, in cases of any model that know them.
void check_cleanliness(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
