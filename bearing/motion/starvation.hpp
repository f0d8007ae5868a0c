// Which reductions of the rolling resistance by inlets that are not flooded a bearing can have.
#pragma once

#include "bearing/motion/parameters.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::bearing::motion {

/// Inconsistencies of rollers at rest. `sized`: bore and outside diameter are known.
mechanics::Problems starvation_problems(Starvation starvation, bool sized);
/// The same of a bearing in motion.
mechanics::Problems starvation_problems(const RaceContactParameters& race, bool sized);

}  // namespace orbearing::bearing::motion
