// Warnings of a catalogue bearing that a case states.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// How far rollers or balls that are inferred from a designation may be off, and which of its ratings the
/// case replaces: what every result of theirs is to be read with.
std::vector<std::string> inferred_warnings(const ResolvedCase& resolved);

/// Messages on a study of the inputs `varied`: it varies a designation, or the catalogue, while the case
/// states ratings or sizes of a cage, which would be the same for all designations.
std::vector<std::string> stated_beside_designation(const ResolvedCase& resolved,
                                                   const std::vector<std::string>& varied);

}  // namespace orbearing::app
