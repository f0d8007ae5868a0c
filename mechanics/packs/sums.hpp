// Operations over all lanes of a pack: any of a mask, sum.
#pragma once

#include "mechanics/packs/pack.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

namespace detail {
// Halves, quarters and neighbours changed over: sums by halving.
#if ORBEARING_REGISTER_LANES == 8
template <class Vector>
Vector upper_half(const Vector& x) {
  return __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3);
}
template <class Vector>
Vector upper_quarter(const Vector& x) {
  return __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5);
}
// Sums of neighbours, then of pairs, then of halves; those of `y` next to those of `x`.
inline Register neighbours(const Register& x, const Register& y) {
  return __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14) +
         __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
}
inline Register pairs(const Register& x, const Register& y) {
  return __builtin_shufflevector(x, y, 0, 1, 8, 9, 4, 5, 12, 13) +
         __builtin_shufflevector(x, y, 2, 3, 10, 11, 6, 7, 14, 15);
}
inline Register halves(const Register& x, const Register& y) {
  return __builtin_shufflevector(x, y, 0, 1, 2, 3, 8, 9, 10, 11) +
         __builtin_shufflevector(x, y, 4, 5, 6, 7, 12, 13, 14, 15);
}
#elif ORBEARING_REGISTER_LANES == 4
template <class Vector>
Vector upper_quarter(const Vector& x) {
  return __builtin_shufflevector(x, x, 2, 3, 0, 1);
}
inline Register neighbours(const Register& x, const Register& y) {
  return __builtin_shufflevector(x, y, 0, 4, 2, 6) + __builtin_shufflevector(x, y, 1, 5, 3, 7);
}
inline Register pairs(const Register& x, const Register& y) {
  return __builtin_shufflevector(x, y, 0, 1, 4, 5) + __builtin_shufflevector(x, y, 2, 3, 6, 7);
}
#else
inline Register neighbours(const Register& x, const Register& y) {
  return __builtin_shufflevector(x, y, 0, 2) + __builtin_shufflevector(x, y, 1, 3);
}
#endif
}  // namespace detail

/// The sums of as many registers as one has lanes, side by side.
inline Register sums(const Register (&x)[kRegisterLanes]) {
#if ORBEARING_REGISTER_LANES == 8
  return detail::halves(detail::pairs(detail::neighbours(x[0], x[1]), detail::neighbours(x[2], x[3])),
                        detail::pairs(detail::neighbours(x[4], x[5]), detail::neighbours(x[6], x[7])));
#elif ORBEARING_REGISTER_LANES == 4
  return detail::pairs(detail::neighbours(x[0], x[1]), detail::neighbours(x[2], x[3]));
#else
  return detail::neighbours(x[0], x[1]);
#endif
}

inline bool any(const Mask& where) {
  BitRegister found = where.low | where.high;
#if ORBEARING_REGISTER_LANES == 8
  found |= detail::upper_half(found);
#endif
#if ORBEARING_REGISTER_LANES >= 4
  found |= detail::upper_quarter(found);
#endif
  return (found[0] | found[1]) != 0;
}

inline bool any(const PackPairMask& where) {
  return any(where.low | where.high);
}

inline double sum(const Pack& x) {
  Register y = x.low + x.high;
#if ORBEARING_REGISTER_LANES == 8
  y += detail::upper_half(y);
#endif
#if ORBEARING_REGISTER_LANES >= 4
  y += detail::upper_quarter(y);
#endif
  return y[0] + y[1];
}

/// The sums of `n` packs, side by side.
template <int n>
inline void sums_of(const Pack (&x)[n], double (&into)[n]) {
#pragma GCC unroll 8
  for (int first = 0; first < n; first += kRegisterLanes) {
    Register parts[kRegisterLanes];
#pragma GCC unroll 8
    for (int i = 0; i < kRegisterLanes; ++i)
      parts[i] = first + i < n ? x[first + i].low + x[first + i].high : Register{};
    const Register all = sums(parts);
    for (int i = 0; i < kRegisterLanes && first + i < n; ++i) into[first + i] = all[i];
  }
}

}  // namespace orbearing::mechanics::ORBEARING_PACKS
