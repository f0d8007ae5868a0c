// Inputs of an analysis that have an effect only under a condition on its other inputs.
#pragma once

#include <string>
#include <vector>

namespace orbearing::mechanics {

/// A condition on inputs.
template <class Inputs>
struct Premise {
  std::vector<std::string> on;   // inputs that it depends on
  bool (*holds)(const Inputs&);  // whether it is met
  std::string value{};           // the choice of `on` that meets it; empty: any of them that is stated
  std::string text{};            // "where operation.speeds is not given"; empty: by the two above
};

/// A stated input whose premises do not hold.
enum class Otherwise {
  warned_of,    // has no effect, which is a mistake as a rule
  not_modelled  // belongs to another analysis, so that a case may state it for that
};

/// Inputs whose keys begin with one of `keys`, and their premises, which must all hold. Of several with the
/// same key one must hold.
template <class Inputs>
struct Conditional {
  std::vector<std::string> keys;
  std::vector<Premise<Inputs>> premises;
  Otherwise otherwise = Otherwise::warned_of;
  bool beside_row = false;  // an effect besides the one under the row's own condition
};

}  // namespace orbearing::mechanics
