// A sweep in words: a table of its main columns, and its longest life. For terminals.
#pragma once

#include <string>
#include <vector>

#include "app/results/sweep_run.hpp"

namespace orbearing::app {

/// How many points have no life, and a line that states the longest life and its speed.
std::string peak_text(const ManifestHeader& header, const std::vector<SweepRow>& rows, const LifePeak& peak);

/// Speed, planet load, largest roller loads, lives and the swept axes, aligned; a failed point shows its
/// status, and whether the point was added to the grid. Of a long sweep every n-th row of the grid and the
/// longest life, with a last line that states this.
std::string sweep_table(const ManifestHeader& header, const std::vector<SweepRow>& rows);

/// Loads, lives, safety and pressure of each of several sets at one point; nothing of one set.
std::string sets_table(const ManifestHeader& header, const SweepRow& row);

}  // namespace orbearing::app
