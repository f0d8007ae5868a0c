// Several doubles at once, from one source for every instruction set: as many as a register of the one this
// file is compiled for holds. Each file that includes it is compiled once per instruction set and names that
// in ORBEARING_LANES, so that the linker never mixes their functions.
#pragma once

#ifndef ORBEARING_LANES
#error "ORBEARING_LANES must name the instruction set this file is compiled for"
#endif

namespace orbearing::bearing::fast::ORBEARING_LANES {

#if defined(__AVX512F__)
inline constexpr int kLanes = 8;
#elif defined(__AVX__)
inline constexpr int kLanes = 4;
#else
inline constexpr int kLanes = 2;
#endif

/// kLanes numbers.
using Pack = double __attribute__((vector_size(8 * kLanes)));
/// kLanes truth values, all bits set for true.
using Mask = long long __attribute__((vector_size(8 * kLanes)));

inline Pack load(const double* from) {
  Pack pack;
  __builtin_memcpy(&pack, from, sizeof pack);
  return pack;
}

inline void store(const Pack& pack, double* to) {
  __builtin_memcpy(to, &pack, sizeof pack);
}

inline Pack spread(double x) {
  return Pack{} + x;
}

inline Pack select(const Mask& where, const Pack& yes, const Pack& no) {
  return (Pack)(((Mask)yes & where) | ((Mask)no & ~where));
}

/// `x` where `where` holds, else zero.
inline Pack only(const Mask& where, const Pack& x) {
  return (Pack)((Mask)x & where);
}

namespace detail {
// The upper half over the lower one, the upper quarter over the next, and so on: sums by halving.
#if defined(__AVX512F__)
template <class Vector>
Vector upper_half(const Vector& x) {
  return __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3);
}
template <class Vector>
Vector upper_quarter(const Vector& x) {
  return __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5);
}
#elif defined(__AVX__)
template <class Vector>
Vector upper_quarter(const Vector& x) {
  return __builtin_shufflevector(x, x, 2, 3, 0, 1);
}
#endif
}  // namespace detail

inline bool any(const Mask& where) {
  Mask bits = where;
#if defined(__AVX512F__)
  bits |= detail::upper_half(bits);
#endif
#if defined(__AVX__)
  bits |= detail::upper_quarter(bits);
#endif
  return (bits[0] | bits[1]) != 0;
}

inline Pack absolute(const Pack& x) {
  return (Pack)((Mask)x & (Mask{} + 0x7fffffffffffffffLL));
}

inline Pack with_sign_of(const Pack& size, const Pack& sign) {
  const Mask bit = Mask{} + static_cast<long long>(0x8000000000000000ULL);
  return (Pack)(((Mask)size & ~bit) | ((Mask)sign & bit));
}

inline Pack larger(const Pack& a, const Pack& b) {
  return select(a > b, a, b);
}

inline Pack smaller(const Pack& a, const Pack& b) {
  return select(a < b, a, b);
}

inline Pack root(const Pack& x) {
  Pack y;
  for (int i = 0; i < kLanes; ++i) y[i] = __builtin_sqrt(x[i]);
  return y;
}

inline double sum(const Pack& x) {
  Pack y = x;
#if defined(__AVX512F__)
  y += detail::upper_half(y);
#endif
#if defined(__AVX__)
  y += detail::upper_quarter(y);
#endif
  return y[0] + y[1];
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
