// Errors and warnings about the inputs of a machine, each with the input that it concerns.
#pragma once

#include <string>
#include <string_view>
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

/// In a text: the input of that key as the case states it, with its unit. Whoever shows the text replaces it
/// (with_inputs()).
inline std::string as_written(std::string_view key) {
  return "{" + std::string(key) + "}";
}

/// The text with its inputs, of which `written` gives each by its key.
template <class Written>
std::string with_inputs(const std::string& text, const Written& written) {
  std::string shown;
  std::size_t begin = 0;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', begin)) {
    const std::size_t close = text.find('}', open);
    shown += text.substr(begin, open - begin) + written(text.substr(open + 1, close - open - 1));
    begin = close + 1;
  }
  return shown + text.substr(begin);
}

/// Both parts of the text of an error.
inline std::pair<std::string, std::string> found_and_required(const std::string& text) {
  const auto split = text.find("; ");
  return {text.substr(0, split), text.substr(split + 2)};
}

}  // namespace orbearing::mechanics
