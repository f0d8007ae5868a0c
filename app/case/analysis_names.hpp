// Names of the analyses for users.
#pragma once

#include <string>
#include <vector>

#include "app/case/field_use.hpp"

namespace orbearing::app {

/// "run and sweep with --fidelity dynamic"
std::string analysis_name(use::Analysis analysis);
/// All of them, in the order in which they are listed.
const std::vector<use::Analysis>& analyses();

}  // namespace orbearing::app
