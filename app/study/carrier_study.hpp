// The carrier as a body in three dimensions: what each planet bearing carries over a revolution, and natural
// frequencies.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/carrier_revolution.hpp"

namespace orbearing::app {

/// Throws BadInput unless the case has one set, its ring held in the housing, and
/// gearset.carrier.bearing_positions.
void require_carrier(const ResolvedCase& resolved);

/// Results of a case that meets require_carrier(). Throws BadInput where lists do not fit together,
/// ComputationFailed where no equilibrium is found.
analysis::CarrierRevolution carrier_study(const ResolvedCase& resolved);

/// Natural frequencies, without rotation, of a case in which carrier_is_body().
void describe_spatial_modes(described::Record& record, const ResolvedCase& resolved);

}  // namespace orbearing::app
