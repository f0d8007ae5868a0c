// What the page shows of a bearing in motion while it is computed, with either engine.
#pragma once

#include <nlohmann/json.hpp>

#include "coupling/system/motion_progress.hpp"

namespace orbearing::app::page {

/// Time, cage and rollers now: {"time_s", "most_s", "expected_s", "run", "most_runs", "rolling_cage_rpm",
/// "cage_rpm", "cage_turned_deg", "cage_um", "angle_deg", "spin_rpm", "inner_load_N", "outer_load_N"}. Speeds
/// are relative to the carrier; without a cage its speed and angle are means over the rollers.
nlohmann::ordered_json motion_event(const system::MotionProgress& now);

}  // namespace orbearing::app::page
