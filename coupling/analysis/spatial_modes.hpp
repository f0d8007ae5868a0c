// Natural modes of a planetary set in three dimensions, on the bearings of its carrier.
#pragma once

#include <vector>

#include "coupling/analysis/multi_stage.hpp"
#include "gearset/spatial/spatial_modes.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Without rotation.
struct SpatialModes {
  std::vector<gearset::spatial::SpatialMode> modes;
};
void describe(described::Record& record, const SpatialModes& of);

/// Modes of a set with a carrier_mounting and a gear_set. Throws std::invalid_argument where lists do not fit
/// together.
SpatialModes spatial_modes(const NamedSet& set);

}  // namespace orbearing::analysis
