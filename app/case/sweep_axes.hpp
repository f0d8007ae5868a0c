// The `sweep:` block: which fields take which values.
#pragma once

#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Most operating points of one sweep.
inline constexpr double most_points = 100000;

/// Reads the axes in the order written; `model` holds the bits of the models whose fields may be swept,
/// `shape` which sets there are.
std::vector<SweepAxis> read_axes(const Entry& sweep, unsigned model, const CaseShape& shape,
                                 std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
