// Inputs of an analysis that have an effect only under a condition on its other inputs.
#pragma once

#include <string>
#include <vector>

namespace orbearing::mechanics {

/// Inputs whose keys begin with one of `keys`, and their condition.
template <class Inputs>
struct Conditional {
  std::vector<std::string> keys;
  std::vector<std::string> on;   // inputs that the condition depends on
  bool (*holds)(const Inputs&);  // whether they have an effect
  std::string text;              // "where operation.shaft_speed is 0"
};

}  // namespace orbearing::mechanics
