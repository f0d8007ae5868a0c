// `gears` of report.json: what the report's pictures of teeth, meshes, modes and vibration need.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether the report of this case has a section on its gears: one set whose teeth are given.
bool has_gear_report(const ResolvedCase& resolved);

/// tooth_pairs, meshes, mode_shapes, campbell, meetings, runs, spectrum. The gears run in time at each of the
/// speeds and at some between; a run that fails says why in its `status`.
/// @param resolved  without a sweep, or on one line of speeds
/// @param speeds_rpm of the sweep, not empty
nlohmann::ordered_json gear_report(const ResolvedCase& resolved, std::vector<double> speeds_rpm);

}  // namespace orbearing::app
