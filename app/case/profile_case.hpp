// The profile of the rollers that a case states, and what does not fit about it.
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::app {

/// Profile of one roller, found once for each case; straight where it has none. Throws std::invalid_argument
/// where it has no meaning.
const bearing::profile::Profile& roller_profile_of(const ResolvedCase& resolved);
const bearing::profile::Profile& roller_profile_of(const ResolvedCase&& resolved) = delete;

/// Objects to a profile that cannot be made, to misalignment without the laminae that it acts on, and to
/// fewer laminae than the governing life requires.
void check_profile(CheckedCase& resolved);

}  // namespace orbearing::app
