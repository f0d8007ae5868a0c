// Errors and warnings about the inputs of a machine, each with the input that it concerns.
#pragma once

#include <string>
#include <vector>

namespace orbearing::mechanics {

/// Finding, and its meaning or requirement; `key` is that of the case file, such as "gearset.teeth". Text of
/// an error: "found; required".
struct Problem {
  std::string key;
  std::string text;
};

using Problems = std::vector<Problem>;

}  // namespace orbearing::mechanics
