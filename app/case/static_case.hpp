// From a resolved case of the models roller-bearing and ball-bearing to a bearing under a static load.
#pragma once

#include "app/case/resolved_case.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/life/standard_life.hpp"
#include "coupling/system/heated_balls.hpp"

namespace orbearing::app {

/// Laminae of rollers where the case states none.
inline constexpr int default_laminae = bearing::rating::kLeastRatedLaminae;

/// Rollers are always cut into laminae. Throws std::invalid_argument where their profile has no meaning.
bearing::Bearing bearing_of(const ResolvedCase& resolved);

/// On the inner ring.
bearing::equilibrium::RingLoad ring_load_of(const ResolvedCase& resolved);

/// How its rings turn.
bearing::equilibrium::RowMotion row_motion_of(const ResolvedCase& resolved);

/// Ratings that the case states instead of the standard's values.
bearing::rating::StatedRatings stated_ratings_of(const ResolvedCase& resolved);

// From a resolved case of a ball bearing with a block `simulation` to its motion in time.

bearing::balls::MotionParameters ball_motion_of(const ResolvedCase& resolved);

/// The load acts on the inner ring, the radial one along x; with an acceleration the ring starts from rest.
bearing::balls::BallDuty ball_duty_of(const ResolvedCase& resolved);

system::BallRunOptions ball_run_options_of(const ResolvedCase& resolved);

system::HeatParameters heat_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
