// Balances of a ball bearing at speed, and films by Reynolds' equation.
#pragma once

#include <nlohmann/json.hpp>

namespace orbearing::bench {

/// Keys "ball_balance_us", "reynolds_129_s" and "reynolds_257_s", processor time of one core.
void put_balances(nlohmann::ordered_json& out);

}  // namespace orbearing::bench
