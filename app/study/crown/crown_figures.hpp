// What the pictures of a crowning study show beyond its result.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/study/crown/crown_options.hpp"

namespace orbearing::app {

/// `profiles` (to scale), `pressure` (curves along the roller, each profile with and without tilt), `zone`
/// (pressure over the load zone), `map` (life over drop and tilt), `fronts` (life against pressure, each kind
/// of profile), `speeds` (life over input speed). `result` is what the command printed as JSON.
nlohmann::ordered_json crown_figures(const ResolvedCase& resolved, const CrownRequest& request,
                                     const nlohmann::ordered_json& result);

}  // namespace orbearing::app
