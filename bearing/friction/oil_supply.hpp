// Oil supply of a bearing in motion, by published formulas that depend on its speed as a whole.
#pragma once

#include "bearing/motion/balls/parameters.hpp"

namespace orbearing::bearing::friction {

/// `given` with its share of oil and starvation evaluated, the rings at `speed` [rad/s] against each other.
/// Throws std::invalid_argument where there is no flow or no speed for a share by both, no bore and outside
/// diameter for starvation, or a starvation model for bearings at rest only.
balls::MotionParameters supplied(const Bearing& bearing, const balls::MotionParameters& given, double speed);

/// The same of rollers: their starvation.
motion::DynamicsParameters supplied(const Bearing& bearing, const motion::DynamicsParameters& given,
                                    double speed);

}  // namespace orbearing::bearing::friction
