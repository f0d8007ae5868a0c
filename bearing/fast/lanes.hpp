// Several doubles at once, from one source for every instruction set: two registers of the one this file is
// compiled for, so that the processor always has two independent chains to work on. Each file that includes
// it is compiled once per instruction set and names that in ORBEARING_LANES, so that the linker never mixes
// their functions.
#pragma once

#ifndef ORBEARING_LANES
#error "ORBEARING_LANES must name the instruction set this file is compiled for"
#endif

namespace orbearing::bearing::fast::ORBEARING_LANES {

#if defined(__AVX512F__)
inline constexpr int kRegisterLanes = 8;
#elif defined(__AVX__)
inline constexpr int kRegisterLanes = 4;
#else
inline constexpr int kRegisterLanes = 2;
#endif
inline constexpr int kLanes = 2 * kRegisterLanes;

using Register = double __attribute__((vector_size(8 * kRegisterLanes)));
using BitRegister = long long __attribute__((vector_size(8 * kRegisterLanes)));

/// kLanes whole numbers, or truth values with all bits set for true.
struct Mask {
  BitRegister low{}, high{};
};

/// kLanes numbers.
struct Pack {
  Register low{}, high{};
};

#define ORBEARING_OPERATOR(Type, op)                      \
  inline Type operator op(const Type& x, const Type& y) { \
    return {x.low op y.low, x.high op y.high};            \
  }
ORBEARING_OPERATOR(Pack, +)
ORBEARING_OPERATOR(Pack, -)
ORBEARING_OPERATOR(Pack, *)
ORBEARING_OPERATOR(Pack, /)
ORBEARING_OPERATOR(Mask, +)
ORBEARING_OPERATOR(Mask, -)
ORBEARING_OPERATOR(Mask, &)
ORBEARING_OPERATOR(Mask, |)
ORBEARING_OPERATOR(Mask, ^)
#undef ORBEARING_OPERATOR

#define ORBEARING_SCALAR_OPERATOR(op)                \
  inline Pack operator op(const Pack& x, double y) { \
    return {x.low op y, x.high op y};                \
  }                                                  \
  inline Pack operator op(double x, const Pack& y) { \
    return {x op y.low, x op y.high};                \
  }
ORBEARING_SCALAR_OPERATOR(+)
ORBEARING_SCALAR_OPERATOR(-)
ORBEARING_SCALAR_OPERATOR(*)
ORBEARING_SCALAR_OPERATOR(/)
#undef ORBEARING_SCALAR_OPERATOR

inline Pack operator-(const Pack& x) {
  return {-x.low, -x.high};
}
inline Pack& operator+=(Pack& x, const Pack& y) {
  return x = x + y;
}
inline Pack& operator-=(Pack& x, const Pack& y) {
  return x = x - y;
}
inline Mask operator~(const Mask& x) {
  return {~x.low, ~x.high};
}
inline Mask operator-(const Mask& x) {
  return {-x.low, -x.high};
}
inline Mask operator<<(const Mask& x, int by) {
  return {x.low << by, x.high << by};
}
inline Mask operator>>(const Mask& x, int by) {
  return {x.low >> by, x.high >> by};
}
inline Mask operator<(const Pack& x, const Pack& y) {
  return {(BitRegister)(x.low < y.low), (BitRegister)(x.high < y.high)};
}
inline Mask operator>(const Pack& x, const Pack& y) {
  return y < x;
}

inline Pack spread(double x) {
  return {Register{} + x, Register{} + x};
}
/// The same bits in every lane.
inline Mask bits(long long x) {
  return {BitRegister{} + x, BitRegister{} + x};
}
inline Mask operator<(const Pack& x, double y) {
  return x < spread(y);
}
inline Mask operator>(const Pack& x, double y) {
  return spread(y) < x;
}

/// The bits of numbers, and numbers from their bits.
inline Mask bits_of(const Pack& x) {
  return {(BitRegister)x.low, (BitRegister)x.high};
}
inline Pack from_bits(const Mask& x) {
  return {(Register)x.low, (Register)x.high};
}

inline Pack load(const double* from) {
  Pack pack;
  __builtin_memcpy(&pack.low, from, sizeof pack.low);
  __builtin_memcpy(&pack.high, from + kRegisterLanes, sizeof pack.high);
  return pack;
}
inline void store(const Pack& pack, double* to) {
  __builtin_memcpy(to, &pack.low, sizeof pack.low);
  __builtin_memcpy(to + kRegisterLanes, &pack.high, sizeof pack.high);
}

/// Lanes up to `count` are true.
inline Mask first_lanes(int count) {
  Mask mask;
  for (int i = 0; i < kRegisterLanes; ++i) {
    mask.low[i] = i < count ? -1LL : 0LL;
    mask.high[i] = i + kRegisterLanes < count ? -1LL : 0LL;
  }
  return mask;
}

inline Pack select(const Mask& where, const Pack& yes, const Pack& no) {
  return from_bits((bits_of(yes) & where) | (bits_of(no) & ~where));
}

/// `x` where `where` holds, else zero.
inline Pack only(const Mask& where, const Pack& x) {
  return from_bits(bits_of(x) & where);
}

inline Pack absolute(const Pack& x) {
  return from_bits(bits_of(x) & bits(0x7fffffffffffffffLL));
}

inline Pack with_sign_of(const Pack& size, const Pack& sign) {
  const Mask bit = bits(static_cast<long long>(0x8000000000000000ULL));
  return from_bits((bits_of(size) & ~bit) | (bits_of(sign) & bit));
}

inline Pack larger(const Pack& a, const Pack& b) {
  return select(a > b, a, b);
}

inline Pack smaller(const Pack& a, const Pack& b) {
  return select(a < b, a, b);
}

inline Pack root(const Pack& x) {
  Pack y;
  for (int i = 0; i < kRegisterLanes; ++i) y.low[i] = __builtin_sqrt(x.low[i]);
  for (int i = 0; i < kRegisterLanes; ++i) y.high[i] = __builtin_sqrt(x.high[i]);
  return y;
}

namespace detail {
// The upper half over the lower one, then the upper quarter over the next: sums by halving.
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
  BitRegister found = where.low | where.high;
#if defined(__AVX512F__)
  found |= detail::upper_half(found);
#endif
#if defined(__AVX__)
  found |= detail::upper_quarter(found);
#endif
  return (found[0] | found[1]) != 0;
}

inline double sum(const Pack& x) {
  Register y = x.low + x.high;
#if defined(__AVX512F__)
  y += detail::upper_half(y);
#endif
#if defined(__AVX__)
  y += detail::upper_quarter(y);
#endif
  return y[0] + y[1];
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
