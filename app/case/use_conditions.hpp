// Conditions of the use of fields that follow from several values at once.
#pragma once

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether a planet whose tilt is computed has one: something makes its two ends unlike.
bool planets_tilt(const ResolvedCase& in);
/// Whether bearings whose tilt is computed have one: beside each other they tilt with the bent pin.
bool bearings_tilt(const ResolvedCase& in);
/// Whether the linear formulas of a duplex pair have a column: a shaft at rest, rows that do not part.
bool pair_has_linear_column(const ResolvedCase& in);
/// The same, or measured pairs from which they are identified.
bool pair_run_has_linear_column(const ResolvedCase& in);

}  // namespace orbearing::app
