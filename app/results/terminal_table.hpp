// The main columns of a sweep, for terminals.
#pragma once

#include <string>
#include <vector>

#include "app/results/result_row.hpp"

namespace orbearing::app {

/// Speed, planet load, largest roller loads, lives and the swept axes, aligned; a failed point shows its
/// status. Of a long sweep every so many-th row, which a last line then says.
std::string sweep_table(const TableHead& head, const std::vector<ResultRow>& rows);

}  // namespace orbearing::app
