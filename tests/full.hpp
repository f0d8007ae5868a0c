// Whether all tests are requested, as by tools/test --full, or the part that is tested with every change.
#pragma once

#include <cstdlib>
#include <string_view>

namespace orbearing::test {

inline bool is_full() {
  const char* full = std::getenv("ORBEARING_FULL");
  return full != nullptr && std::string_view(full) == "yes";
}

}  // namespace orbearing::test
