// The carrier as a body in three dimensions: what each planet bearing carries over a revolution, and natural
// frequencies.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/study/carrier_revolution.hpp"

namespace orbearing::app {

struct CarrierStudy {
  study::CarrierRevolution revolution;
  std::vector<std::string> warnings;
};

void describe(described::Record& record, const CarrierStudy& study);

/// Throws BadInput unless the case has one set, its ring held in the housing, and
/// gearset.carrier.bearing_positions.
void require_carrier(const ResolvedCase& resolved);

/// Of a case that require_carrier() takes. Throws BadInput where lists do not fit together, ComputationFailed
/// where no balance is found.
CarrierStudy carrier_study(const ResolvedCase& resolved);

/// Natural frequencies of a case in which carrier_is_body(), at rest.
struct SpatialModes {
  std::vector<gearset::spatial::SpatialMode> modes;
};
void describe(described::Record& record, const SpatialModes& study);
SpatialModes spatial_modes(const ResolvedCase& resolved);

}  // namespace orbearing::app
