// Checks of drivetrains with a scratched planet bearing.
#pragma once

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether a case is that of a drivetrain with a scratched planet bearing: it has a block `defect`.
bool is_planet_defect(const ResolvedCase& resolved);

/// Adds what is wrong; nothing for other cases.
void check_defect(CheckedCase& resolved);
/// The same for a drivetrain of several sets, whose sets and shafts are checked before.
void check_defect_of_sets(CheckedCase& resolved);

}  // namespace orbearing::app
