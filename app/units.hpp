// Units in which numbers leave the program, besides those of the case table.
#pragma once

#include "mechanics/constants.hpp"


namespace orbearing::app {

inline constexpr double kRpm = 30.0 / constants::pi;               // per rad/s
inline constexpr double kRadiansPerSecond = constants::pi / 30.0;  // of 1 rpm
inline constexpr double kDegree = 180.0 / constants::pi;           // per rad
inline constexpr double per_kilo = 1e-3;                           // per unit
inline constexpr double per_milli = 1e3;                           // per unit
inline constexpr double per_micro = 1e6;                           // per unit
inline constexpr double per_mega = 1e-6;                           // per unit

}  // namespace orbearing::app
