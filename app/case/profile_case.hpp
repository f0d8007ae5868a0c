// From a resolved case to the profile of its rollers.
#pragma once

#include "app/case/resolved_case.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::app {

/// The profile that `bearing.profile` states, for rollers under the load of the case. Throws
/// std::invalid_argument where it has no meaning, with what was found and what is required.
bearing::profile::Profile profile_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
