// The profile of the rollers that a case states, and what does not fit about it.
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::app {

/// Profile of one roller; straight where the case has none. Throws std::invalid_argument where it has no
/// meaning.
bearing::profile::Profile roller_profile_of(const ResolvedCase& resolved);

/// Objects to a profile that cannot be made, to misalignment without the laminae that it acts on, and to
/// fewer laminae than the governing life requires.
void check_profile(CheckedCase& resolved);

}  // namespace orbearing::app
