// Elastic line contact, Q = K e^(10/9): the law's exponent, once for plain numbers and packs.
#pragma once

namespace orbearing::bearing {

inline constexpr double kLineExponent = 10.0 / 9.0;          // of the load over the elastic approach
inline constexpr double kLineApproachExponent = 9.0 / 10.0;  // of the elastic approach over the load

}  // namespace orbearing::bearing
