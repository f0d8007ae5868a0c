// The carrier as a body in three dimensions: what each planet bearing carries over a revolution.
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

/// Of a case with one set, its ring held in the housing, and gearset.carrier.bearing_positions. Throws
/// BadInput for another, ComputationFailed where no balance is found.
CarrierStudy carrier_study(const ResolvedCase& resolved);

}  // namespace orbearing::app
