// Checks of drivetrains with a scratched planet bearing.
#pragma once

#include <optional>
#include <string>

#include "app/case/resolved_case.hpp"
#include "gearset/parameters.hpp"

namespace orbearing::app {

/// Whether a case is that of a drivetrain with a scratched planet bearing: it has a block `defect`.
bool is_planet_defect(const ResolvedCase& resolved);

/// The member of one of several sets that the housing holds; none: all of them turn.
std::optional<gearset::Member> held_member_of(const ResolvedCase& resolved, const std::string& set);

/// Adds what is wrong; nothing for other cases.
void check_defect(CheckedCase& resolved);
/// The same for a drivetrain of several sets, whose sets and shafts are checked before.
void check_defect_of_sets(CheckedCase& resolved);

}  // namespace orbearing::app
