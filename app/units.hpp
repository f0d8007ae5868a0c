// Units in which numbers leave the program, besides those of the case table.
#pragma once

#include <numbers>

namespace orbearing::app {

inline constexpr double kRpm = 30.0 / std::numbers::pi;               // per rad/s
inline constexpr double kRadiansPerSecond = std::numbers::pi / 30.0;  // of 1 rpm
inline constexpr double kDegree = 180.0 / std::numbers::pi;           // per rad
inline constexpr double kMilli = 1e3;                                 // per unit
inline constexpr double kMicro = 1e6;                                 // per unit
inline constexpr double kMega = 1e-6;                                 // per unit

}  // namespace orbearing::app
