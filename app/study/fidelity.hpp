// The rungs of the fidelity ladder as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/study/operating_point.hpp"

namespace orbearing::app {

/// In rising order: quasi-static, dynamic, co-simulated, monolithic.
const std::vector<std::string>& fidelity_names();

/// The rung called `name`. @throws std::out_of_range for any other name
study::Fidelity fidelity_of(const std::string& name);  // throws BadInput for another name

/// Whether the bearing moves in time.
inline bool in_time(study::Fidelity fidelity) {
  return fidelity != study::Fidelity::quasi_static;
}

/// Whether the bearings act back on the gears.
inline bool is_coupled(study::Fidelity fidelity) {
  return fidelity == study::Fidelity::co_simulated || fidelity == study::Fidelity::monolithic;
}

// What of a case a computation can take.

/// Throws BadInput where the case holds what `fidelity` ought to compute and cannot, or what a sweep cannot.
void require_computable(const ResolvedCase& resolved, const std::string& fidelity, bool sweep);

}  // namespace orbearing::app
