#pragma once

#include <compare>
#include <optional>
#include <string>

namespace orbearing::app {

/// Replacement of one independent value.
struct Setting {
  std::string path;                // of a list of numbers also "PATH[i]", its element i, counted from 0
  std::string text;                // as in a case; empty: the number says it
  std::optional<double> number{};  // [SI] where the text has been read or there is none

  auto operator<=>(const Setting&) const = default;
};

}  // namespace orbearing::app
