// From a resolved case of the models roller-bearing and ball-bearing to bearings under a static load.
#pragma once

#include "app/case/resolved_case.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/rollers.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::app {

/// Laminae where the case states none.
inline constexpr int default_laminae = 40;

/// Always cut into laminae. Throws std::invalid_argument where the profile has no meaning.
bearing::CylindricalRollerBearing lamina_bearing_of(const ResolvedCase& resolved);
bearing::BallBearing ball_bearing_of(const ResolvedCase& resolved);

/// On the inner ring of either.
bearing::equilibrium::RingLoad ring_load_of(const ResolvedCase& resolved);

bearing::rating::RollerSet roller_set_of(const ResolvedCase& resolved);

/// How the races move relative to the load.
bearing::rating::RaceMotions race_motions_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
