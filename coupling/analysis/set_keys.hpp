// Keys of the inputs of one of several sets.
#pragma once

#include <string>
#include <string_view>

namespace orbearing::analysis {

/// Beginning of the keys of a set, "sets.NAME."; empty for a single set, which has no name.
inline std::string set_prefix(std::string_view set) {
  return set.empty() ? std::string() : "sets." + std::string(set) + ".";
}

}  // namespace orbearing::analysis
