// From a resolved case to what refines a drivetrain's bearing, and which of it a computation can take.
#pragma once

#include <string>

#include "app/case/resolved_case.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::app {

/// Puts forms of the races, unequal rollers, mixed lubrication, pocket films, printed variants, the
/// misalignment and the run-up of a case into `drivetrain`.
void add_refinements(const ResolvedCase& resolved, study::PlanetaryDrivetrain& drivetrain);

/// Throws BadInput where the case holds what `fidelity` ought to compute and cannot, or what a sweep cannot.
void require_computable(const ResolvedCase& resolved, const std::string& fidelity, bool sweep);

}  // namespace orbearing::app
