// Requirements that a case states: limits of lives, pressures and factors, which results are judged by.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// One limit.
struct Requirement {
  std::string name;      // "life", as in the case
  std::string key;       // of the result that it limits: "L10mh"
  std::string unit;      // of the limit and of that result; empty: a ratio
  double limit = 0.0;    // [unit]
  bool at_most = false;  // else at least
};

/// Inputs that state a limit.
std::vector<std::string> requirement_paths();

/// In the order of the block; none where the case states none.
std::vector<Requirement> stated_requirements(const ResolvedCase& resolved);

}  // namespace orbearing::app
