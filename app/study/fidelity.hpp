// The rungs of the fidelity ladder as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/operating_point.hpp"

namespace orbearing::app {

/// In rising order: quasi-static, dynamic, co-simulated, monolithic.
const std::vector<std::string>& fidelity_names();

/// The rung called `name`. @throws std::out_of_range for any other name
analysis::Fidelity fidelity_of(const std::string& name);  // throws BadInput for another name

/// Whether the bearing moves in time.
inline bool in_time(analysis::Fidelity fidelity) {
  return fidelity != analysis::Fidelity::quasi_static;
}

/// Whether the bearings act back on the gears.
inline bool is_coupled(analysis::Fidelity fidelity) {
  return fidelity == analysis::Fidelity::co_simulated || fidelity == analysis::Fidelity::monolithic;
}

// Inputs of a case that a computation includes.

/// Throws BadInput where the case has inputs that `fidelity` should include and cannot, or that a sweep
/// cannot.
void require_computable(const ResolvedCase& resolved, const std::string& fidelity, bool sweep);

}  // namespace orbearing::app
