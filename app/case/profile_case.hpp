// The profile of the rollers that a case states, and what does not fit about it.
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::app {

/// Profile of one roller; straight where the case states none. Throws std::invalid_argument where it has no
/// meaning.
bearing::profile::Profile roller_profile_of(const ResolvedCase& resolved);

/// Objects to a profile that cannot be made, and to profile or misalignment without the laminae that
/// are affected by them.
void check_profile(CheckedCase& resolved);

}  // namespace orbearing::app
