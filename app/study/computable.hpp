// What of a case a computation can take.
#pragma once

#include <string>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Throws BadInput where the case holds what `fidelity` ought to compute and cannot, or what a sweep cannot.
void require_computable(const ResolvedCase& resolved, const std::string& fidelity, bool sweep);

}  // namespace orbearing::app
