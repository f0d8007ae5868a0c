// Which inputs need not be stated, since others give them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/field_use.hpp"

namespace orbearing::app {

// A value that follows from the inputs of a case, as `check` lists it.

/// A quantity that follows from the inputs.
struct Derived {
  std::string path;    // "gearset.centre_distance"
  double value = 0.0;  // [unit]
  std::string unit;    // "mm"; "1" for a ratio
  std::string meaning;
};

/// Where one of these holds, the input at `path` follows from another one and may be left out; none: it never
/// does.
std::vector<Condition> given_by(std::string_view path);

}  // namespace orbearing::app
