// The speed at which a sweep finds the longest life, on its grid and between the grid's points.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_json.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

/// Peak of life on the grid and, on the axis of input.speed through the best point, between the grid's
/// points; NaN where speed is not swept. Between points life follows the quasi-static model, lifted to meet
/// the rows.
struct FoundPeak {
  LifePeak peak;
  std::vector<std::string> warnings;
};
FoundPeak find_peak(const ResolvedCase& resolved, const SweepOutcome& outcome);

}  // namespace orbearing::app
