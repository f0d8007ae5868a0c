// What the status of a point says: "ok"; "implausible: ..." of one whose values are there and cannot be those of a
// machine; else why it failed.
#pragma once

#include <string_view>

namespace orbearing::app {

inline constexpr std::string_view kImplausible = "implausible: ";

/// Whether the point was computed and has values.
inline bool is_computed(std::string_view status) {
  return status == "ok" || status.starts_with(kImplausible);
}

}  // namespace orbearing::app
