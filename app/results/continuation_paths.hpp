// The paths of a continued sweep: points that differ in speed alone, in the order in which they follow each
// other.
#pragma once

#include <cstddef>
#include <vector>

#include "app/results/manifest.hpp"
#include "app/results/sweep_point.hpp"

namespace orbearing::app {

/// Numbers of the points, one path for each combination of the other axes' values, in the order of the
/// points that begin them; along a path the speed rises (up) or falls (down).
std::vector<std::vector<std::size_t>> continuation_paths(const std::vector<SweepPoint>& points, Direction direction);

}  // namespace orbearing::app
