// Elastic line contact, Q = K e^(10/9): the law's exponent, in one place for plain numbers and packs.
#pragma once

namespace orbearing::bearing {

inline constexpr double kLineExponent = 10.0 / 9.0;          // of the load over the elastic approach
inline constexpr double kLineApproachExponent = 9.0 / 10.0;  // of the elastic approach over the load

/// Share of the lengths whose difference an approach is, below which it is round-off and what a search leaves.
/// The load of such a contact is 5e-14 of a full one's, but its stiffness, which is proportional to the ninth
/// root of the approach, still 5 %: rollers a quarter turn from the load would stiffen a bearing across it.
inline constexpr double kLeastApproach = 1e-12;  // [-]

/// `approach` [m], or none where it is that little beside `lengths` [m].
constexpr double without_round_off(double approach, double lengths) {
  const double size = approach < 0.0 ? -approach : approach;
  return size <= kLeastApproach * lengths ? 0.0 : approach;
}

}  // namespace orbearing::bearing
