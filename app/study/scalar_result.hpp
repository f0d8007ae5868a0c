// One number of what `run` prints, of a case and of its variants.
#pragma once

#include <functional>
#include <string>

#include "app/study/analysis.hpp"

namespace orbearing::app {

struct ScalarResult {
  struct Value {
    double number = 0.0;  // [unit]  NaN where the run gives none
    std::string of_set;   // of several sets, the one whose bearings live shortest; else empty
  };

  std::string quantity;  // its key: "life_h", "displacement/radial_um"
  std::string unit;      // of a life, "h" or "Mrev"; else empty: the key ends with it
  use::Analysis analysis = use::quasi_static;
  double scatter = scatter::at_rest;
  /// Throws as the case's own analysis. May be called from several threads.
  std::function<Value(const ResolvedCase&)> compute;

  bool is_at_rest() const { return scatter < scatter::in_motion; }
};

/// The number at `key`, parts of a path joined by '/', of the run of the case at its operating point; without
/// a key the life that results go by. `fidelity`: empty where the user named none. Throws BadInput where the case has none.
ScalarResult scalar_result(const ResolvedCase& resolved, const std::string& fidelity = "",
                           const std::string& key = "");

/// That of the case itself. Throws BadInput or ComputationFailed where its run gives none.
ScalarResult::Value value_here(const ResolvedCase& resolved, const ScalarResult& result);

}  // namespace orbearing::app
