// Errors and warnings about the inputs of a machine, each with the input that it concerns.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace orbearing::mechanics {

/// Finding, and its meaning or requirement; `key` is that of the case file, such as "gearset.teeth". Text of
/// an error: "found; required".
struct Problem {
  std::string key;
  std::string text;
};

using Problems = std::vector<Problem>;

/// Both parts of the text of an error.
inline std::pair<std::string, std::string> found_and_required(const std::string& text) {
  const auto split = text.find("; ");
  return {text.substr(0, split), text.substr(split + 2)};
}

}  // namespace orbearing::mechanics
