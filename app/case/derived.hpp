// A value that follows from the inputs of a case, as `check` lists it.
#pragma once

#include <string>

namespace orbearing::app {

/// A quantity that follows from the inputs.
struct Derived {
  std::string path;    // "gearset.centre_distance"
  double value = 0.0;  // [unit]
  std::string unit;    // "mm"; "1" for a ratio
  std::string meaning;
};

}  // namespace orbearing::app
