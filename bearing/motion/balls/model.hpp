// From what a user states to the constants of a ball bearing in motion.
#pragma once

#include "bearing/motion/balls/numbers.hpp"
#include "bearing/motion/balls/parameters.hpp"

namespace orbearing::bearing::balls {

/// Throws std::invalid_argument for rollers, for grooves no wider than balls, and where masses, clearances or
/// oil that the motion needs are missing.
BallNumbers ball_numbers(const Bearing& bearing, const MotionParameters& parameters);

}  // namespace orbearing::bearing::balls
