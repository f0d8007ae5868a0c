// Cost of dynamic operating points from start to life, and growth of the cost of a step with its bearing.
#pragma once

#include <nlohmann/json.hpp>

namespace orbearing::bench {

/// Dynamic operating points per second and core, for neighbouring speeds and for the twelve of the case,
/// driven by the gears in motion; quartiles into out["spreads"].
void put_points(nlohmann::ordered_json& out);

/// Computing time of a millisecond of motion by the number of laminae in a contact; quartiles into
/// out["spreads"].
void put_laminae(nlohmann::ordered_json& out);

}  // namespace orbearing::bench
