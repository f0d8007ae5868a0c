// From a resolved case to the numbers of an FMU.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/fmu/number_table.hpp"

namespace orbearing::app {

/// One bearing of one planet, its speeds and its load at the start those of the case's operating point. Throws BadInput
/// for a case of another model, of several sets, without bearing or with what has no place in a driven
/// bearing.
fmu::NumberTable bearing_numbers(const ResolvedCase& resolved);

/// The gear set with its planet bearings left out; at the start they hold the mean loads of the case. Throws
/// BadInput for a case of another model, of several sets or without teeth.
fmu::NumberTable gear_numbers(const ResolvedCase& resolved);

}  // namespace orbearing::app
