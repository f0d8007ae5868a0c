// From a resolved case of a ball bearing with a block `simulation` to its motion in time.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/system/heated_balls.hpp"

namespace orbearing::app {

bearing::balls::MotionParameters ball_motion_of(const ResolvedCase& resolved);

/// The load acts on the inner ring, the radial one along x; with an acceleration the ring starts from rest.
bearing::balls::BallDuty ball_duty_of(const ResolvedCase& resolved);

system::BallRunOptions ball_run_options_of(const ResolvedCase& resolved);

system::HeatParameters heat_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
