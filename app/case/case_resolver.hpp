// The tree of a case -> checked values, defaults, assumptions and sweep axes.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Checks a whole tree and appends every mistake; what could be read stands in the result even so.
CaseData resolve(const Entry& root, const std::string& file, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
