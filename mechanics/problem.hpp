// What is wrong with the inputs of a machine, or worth knowing of them, tied to the input that it concerns.
#pragma once

#include <string>
#include <vector>

namespace orbearing::mechanics {

/// What was found and what it means or asks for; `key` is that of the case file, such as "gearset.teeth". Of
/// a refusal the text is "found; required".
struct Problem {
  std::string key;
  std::string text;
};

using Problems = std::vector<Problem>;

}  // namespace orbearing::mechanics
