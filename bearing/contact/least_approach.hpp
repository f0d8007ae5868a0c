// When an approach counts as none: for plain numbers and packs. No header of a library here, since files
// compiled for special instruction sets include it.
#pragma once

namespace orbearing::bearing {

/// Share of the lengths whose difference an approach is, below which it is round-off and what a search
/// leaves. The load of such a contact is 5e-14 of a full one's, but its stiffness, which is proportional to
/// the ninth root of the approach, still 5 %: rollers a quarter turn from the load would stiffen a bearing
/// across it.
inline constexpr double kLeastApproach = 1e-12;  // [-]

/// `approach` [m], or none if it is that small compared with `lengths` [m].
constexpr double without_round_off(double approach, double lengths) {
  const double size = approach < 0.0 ? -approach : approach;
  return size <= kLeastApproach * lengths ? 0.0 : approach;
}

}  // namespace orbearing::bearing
