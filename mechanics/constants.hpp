#pragma once

#include <numbers>

/// Mathematical constants: those of <numbers>, and multiples of pi.
namespace orbearing::constants {

using std::numbers::pi;
inline constexpr double two_pi = 2.0 * pi;
inline constexpr double half_pi = 0.5 * pi;
inline constexpr double degree = pi / 180.0;  // [rad]

}  // namespace orbearing::constants
