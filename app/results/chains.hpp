// A continued sweep as chains: points that differ in speed alone, in the order in which they follow each
// other.
#pragma once

#include <cstddef>
#include <vector>

#include "app/results/manifest.hpp"
#include "app/results/sweep_point.hpp"

namespace orbearing::app {

/// Numbers of the points, one chain for each combination of the other axes' values, in the order of the
/// points that begin them; within a chain the speed rises (up) or falls (down).
std::vector<std::vector<std::size_t>> chains_of(const std::vector<SweepPoint>& points, Direction direction);

}  // namespace orbearing::app
