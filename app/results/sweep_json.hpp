// The sweep as one JSON object, and the peak of its life.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/sweep_run.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Longest life over speed: the best point of the grid, and the best of all where points were added around
/// it. Every number is that of a point that was computed; NaN where there is none.
struct LifePeak {
  double speed_rpm = std::numeric_limits<double>::quiet_NaN();
  double life_h = std::numeric_limits<double>::quiet_NaN();
  double refined_speed_rpm = std::numeric_limits<double>::quiet_NaN();
  double refined_life_h = std::numeric_limits<double>::quiet_NaN();
  double lower_rpm = std::numeric_limits<double>::quiet_NaN();  // neighbours of the refined peak, which live
  double upper_rpm = std::numeric_limits<double>::quiet_NaN();  // shorter; NaN beyond an end of the range
  std::string life{"life_h"};                                   // column of the life whose peak it is
};

void describe(described::Record& record, const LifePeak& peak);

/// Best row of the grid, those added to it left out; the refined values are left for the caller. NaN where no
/// point has a life.
LifePeak grid_peak(const TableHead& head, const std::vector<ResultRow>& rows);

/// The peak and one point that stands for all: rows hold numbers alone.
described::Record sweep_form(const LifePeak& peak);

/// Object with `points`, `peak`, `spectrum` where the case states one, `assumptions`, `warnings`, `versions`
/// and `units`, in this order; no number where a value is missing, but null. Assumptions, warnings and
/// versions are taken as they are.
nlohmann::ordered_json sweep_json(const SweepOutcome& outcome, const LifePeak& peak,
                                  const nlohmann::ordered_json& assumptions,
                                  const nlohmann::ordered_json& warnings,
                                  const nlohmann::ordered_json& versions);

}  // namespace orbearing::app
