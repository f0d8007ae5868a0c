// The speed at which a sweep finds the longest life: points that were computed, nothing between them.
#pragma once

#include <string>
#include <vector>

#include "app/results/sweep_json.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/peak_search.hpp"

namespace orbearing::app {

/// The rows that differ from `row` in speed alone, ascending in speed; those that failed have no life.
std::vector<LivedSpeed> line_through(const TableHead& head, const std::vector<ResultRow>& rows,
                                     const ResultRow& row);

/// Peak of life on the grid and, where it was refined, of all points on the line of speeds through the grid's
/// best; with what must be said of it: that it stands at an end of the range, beside a failed point, or is
/// not as well known as it should be.
struct FoundPeak {
  LifePeak peak;
  std::vector<std::string> warnings;
};
FoundPeak find_peak(const SweepOutcome& outcome);

}  // namespace orbearing::app
