// The main columns of a sweep, for terminals.
#pragma once

#include <string>
#include <vector>

#include "app/results/result_row.hpp"

namespace orbearing::app {

/// Speed, planet load, largest roller loads, lives and the swept axes, aligned; a failed point shows its
/// status, and says whether the point was added to the grid. Of a long sweep every so many-th row of the grid
/// and the longest life, which a last line then says.
std::string sweep_table(const TableHead& head, const std::vector<ResultRow>& rows);

}  // namespace orbearing::app
