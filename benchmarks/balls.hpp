// A deep-groove ball bearing at 4000 rpm by each of the integrators that are compared.
#pragma once

#include <nlohmann/json.hpp>

namespace orbearing::bench {

/// Real-time factor, its ratio per element to `roller_real_time` of a bearing with `rollers`, ratios of time over
/// dopri5 and over the printed form with the classic Runge-Kutta method, each at equal statistics, and the errors of
/// all. Keys begin with "ball_".
void put_balls(double roller_real_time, int rollers, nlohmann::ordered_json& out);

}  // namespace orbearing::bench
