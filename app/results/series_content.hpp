// The motion in time as named arrays of a point's file: dimensions time, roller and direction.
#pragma once

#include "app/results/point_content.hpp"
#include "coupling/system/steady_state.hpp"

namespace orbearing::app {

/// Appends one orbit of the rollers of the dynamic bearing to `content`.
void add_series(const system::BearingSeries& series, PointContent& content);

/// Variable that holds the state in which the motion ended.
inline constexpr const char* final_state_name = "final_state";

/// Appends that state, each variable named with its unit in the array's meaning. Nothing for an empty one.
void add_final_state(const Eigen::VectorXd& state, const bearing::motion::StateLayout& layout,
                     PointContent& content);

}  // namespace orbearing::app
