// Mistakes in the profile of the rollers that a case states.
#pragma once

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Objects to a profile that cannot be made, to misalignment without the laminae that it acts on, and to
/// fewer laminae than the governing life requires.
void check_profile(CheckedCase& resolved);

}  // namespace orbearing::app
