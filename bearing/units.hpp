// Units of the standards' formulae, and what a bearing that nothing loads lives.
#pragma once

#include <limits>

namespace orbearing::bearing {

inline constexpr double kMillimetres = 1e3;         // per metre: the constants of standards hold in N and mm
inline constexpr double kMillionRevolutions = 1e6;  // [revolutions]  unit of L10
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace orbearing::bearing
