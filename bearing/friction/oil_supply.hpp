// How much oil there is where a bearing in motion needs it, by published formulas that go by its speed as a
// whole.
#pragma once

#include "bearing/motion/balls/parameters.hpp"

namespace orbearing::bearing::friction {

/// `given` with the share of oil and the starvation that it asks for, the rings at `speed` [rad/s] against
/// each other. Throws std::invalid_argument where there is no flow or no speed for a share by both, no bore
/// and outside diameter for starvation, or starvation by what only bearings at rest know.
balls::MotionParameters supplied(const Bearing& bearing, const balls::MotionParameters& given, double speed);

/// The same of rollers: their starvation.
motion::DynamicsParameters supplied(const Bearing& bearing, const motion::DynamicsParameters& given,
                                    double speed);

}  // namespace orbearing::bearing::friction
