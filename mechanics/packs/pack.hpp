// Several doubles at once, from one source for every instruction set: two registers of the one this file is
// compiled for, so that the processor always has two independent chains to work on. Each file that includes
// it is compiled once per instruction set and names that in ORBEARING_PACKS, so that the linker never mixes
// their functions.
#pragma once

#ifndef ORBEARING_PACKS
#error "ORBEARING_PACKS must name the instruction set this file is compiled for"
#endif

// Numbers in a register. A file may ask for shorter ones than its instruction set has: for few elements, who
// would leave lanes empty.
#ifndef ORBEARING_REGISTER_LANES
#if defined(__AVX512F__)
#define ORBEARING_REGISTER_LANES 8
#elif defined(__AVX__)
#define ORBEARING_REGISTER_LANES 4
#else
#define ORBEARING_REGISTER_LANES 2
#endif
#endif

namespace orbearing::mechanics::ORBEARING_PACKS {

inline constexpr int kRegisterLanes = ORBEARING_REGISTER_LANES;
inline constexpr int kLanes = 2 * kRegisterLanes;

using Register = double __attribute__((vector_size(8 * kRegisterLanes)));
using BitRegister = long long __attribute__((vector_size(8 * kRegisterLanes)));

/// Two of a kind side by side: two registers, or the numbers of two races. Arithmetic goes part by part. Not
/// set to zero unless requested by PackPair{}, since there are many of them.
template <class Part>
struct Two {
  Part low, high;
};

/// The same for whole numbers, and for truth values with all bits set for true.
template <class Part>
struct TwoBits {
  Part low, high;
};

using Pack = Two<Register>;         // kLanes numbers, one of each roller
using Mask = TwoBits<BitRegister>;  // and truth values
using PackPair = Two<Pack>;         // one number of each roller at the inner race and one at the outer
using PackPairMask = TwoBits<Mask>;
using NumberPair = Two<double>;  // one number of the inner race and one of the outer

#define ORBEARING_OPERATOR(Kind, op)                                        \
  template <class Part>                                                     \
  inline Kind<Part> operator op(const Kind<Part>& x, const Kind<Part>& y) { \
    return {x.low op y.low, x.high op y.high};                              \
  }
ORBEARING_OPERATOR(Two, +)
ORBEARING_OPERATOR(Two, -)
ORBEARING_OPERATOR(Two, *)
ORBEARING_OPERATOR(Two, /)
ORBEARING_OPERATOR(TwoBits, +)
ORBEARING_OPERATOR(TwoBits, -)
ORBEARING_OPERATOR(TwoBits, &)
ORBEARING_OPERATOR(TwoBits, |)
ORBEARING_OPERATOR(TwoBits, ^)
#undef ORBEARING_OPERATOR

// With one number for all, one for each race, or one of each roller for both races.
#define ORBEARING_MIXED_OPERATOR(op)                                    \
  template <class Part>                                                 \
  inline Two<Part> operator op(const Two<Part>& x, double y) {          \
    return {x.low op y, x.high op y};                                   \
  }                                                                     \
  template <class Part>                                                 \
  inline Two<Part> operator op(double x, const Two<Part>& y) {          \
    return {x op y.low, x op y.high};                                   \
  }                                                                     \
  inline PackPair operator op(const PackPair& x, const NumberPair& y) { \
    return {x.low op y.low, x.high op y.high};                          \
  }                                                                     \
  inline PackPair operator op(const NumberPair& x, const PackPair& y) { \
    return {x.low op y.low, x.high op y.high};                          \
  }                                                                     \
  inline PackPair operator op(const NumberPair& x, const Pack& y) {     \
    return {x.low op y, x.high op y};                                   \
  }                                                                     \
  inline PackPair operator op(const PackPair& x, const Pack& y) {       \
    return {x.low op y, x.high op y};                                   \
  }                                                                     \
  inline PackPair operator op(const Pack& x, const PackPair& y) {       \
    return {x op y.low, x op y.high};                                   \
  }
ORBEARING_MIXED_OPERATOR(+)
ORBEARING_MIXED_OPERATOR(-)
ORBEARING_MIXED_OPERATOR(*)
ORBEARING_MIXED_OPERATOR(/)
#undef ORBEARING_MIXED_OPERATOR

template <class Part>
inline Two<Part> operator-(const Two<Part>& x) {
  return {-x.low, -x.high};
}
template <class Part, class Other>
inline Two<Part>& operator+=(Two<Part>& x, const Other& y) {
  return x = x + y;
}
template <class Part, class Other>
inline Two<Part>& operator-=(Two<Part>& x, const Other& y) {
  return x = x - y;
}
template <class Part>
inline TwoBits<Part> operator~(const TwoBits<Part>& x) {
  return {~x.low, ~x.high};
}
template <class Part>
inline TwoBits<Part> operator-(const TwoBits<Part>& x) {
  return {-x.low, -x.high};
}
template <class Part>
inline TwoBits<Part> operator<<(const TwoBits<Part>& x, int by) {
  return {x.low << by, x.high << by};
}
template <class Part>
inline TwoBits<Part> operator>>(const TwoBits<Part>& x, int by) {
  return {x.low >> by, x.high >> by};
}

/// The same number, or the same bits, everywhere.
template <class Number = Pack>
inline Number spread(double x) {
  return Number{} + x;
}
inline PackPair spread(const NumberPair& x) {
  return {spread(x.low), spread(x.high)};
}
template <class Part>
inline TwoBits<Part> plus_bits(const TwoBits<Part>& x, long long y) {
  if constexpr (requires { x.low.low; })
    return {plus_bits(x.low, y), plus_bits(x.high, y)};
  else
    return {x.low + y, x.high + y};
}
template <class Bits = Mask>
inline Bits bits(long long x) {
  return plus_bits(Bits{}, x);
}

inline Mask operator<(const Pack& x, const Pack& y) {
  return {(BitRegister)(x.low < y.low), (BitRegister)(x.high < y.high)};
}
inline PackPairMask operator<(const PackPair& x, const PackPair& y) {
  return {x.low < y.low, x.high < y.high};
}
template <class Part>
inline auto operator>(const Two<Part>& x, const Two<Part>& y) {
  return y < x;
}
template <class Part>
inline auto operator<(const Two<Part>& x, double y) {
  return x < spread<Two<Part>>(y);
}
template <class Part>
inline auto operator>(const Two<Part>& x, double y) {
  return spread<Two<Part>>(y) < x;
}

/// The bits of numbers, and numbers from their bits.
inline Mask bits_of(const Pack& x) {
  return {(BitRegister)x.low, (BitRegister)x.high};
}
inline PackPairMask bits_of(const PackPair& x) {
  return {bits_of(x.low), bits_of(x.high)};
}
inline Pack from_bits(const Mask& x) {
  return {(Register)x.low, (Register)x.high};
}
inline PackPair from_bits(const PackPairMask& x) {
  return {from_bits(x.low), from_bits(x.high)};
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

template <class Bits, class Part>
inline Two<Part> select(const Bits& where, const Two<Part>& yes, const Two<Part>& no) {
  return from_bits((bits_of(yes) & where) | (bits_of(no) & ~where));
}

/// `x` where `where` holds, else zero.
template <class Bits, class Part>
inline Two<Part> only(const Bits& where, const Two<Part>& x) {
  return from_bits(bits_of(x) & where);
}

template <class Part>
inline Two<Part> absolute(const Two<Part>& x) {
  return from_bits(bits_of(x) & bits<decltype(bits_of(x))>(0x7fffffffffffffffLL));
}

template <class Part>
inline Two<Part> with_sign_of(const Two<Part>& size, const Two<Part>& sign) {
  const auto bit = bits<decltype(bits_of(size))>(static_cast<long long>(0x8000000000000000ULL));
  return from_bits((bits_of(size) & ~bit) | (bits_of(sign) & bit));
}

template <class Part>
inline Two<Part> larger(const Two<Part>& a, const Two<Part>& b) {
  return select(a > b, a, b);
}

template <class Part>
inline Two<Part> smaller(const Two<Part>& a, const Two<Part>& b) {
  return select(a < b, a, b);
}
inline PackPair larger(const PackPair& a, const NumberPair& b) {
  return larger(a, spread(b));
}
inline PackPair smaller(const PackPair& a, const NumberPair& b) {
  return smaller(a, spread(b));
}

inline Pack root(const Pack& x) {
  Pack y;
  for (int i = 0; i < kRegisterLanes; ++i) y.low[i] = __builtin_sqrt(x.low[i]);
  for (int i = 0; i < kRegisterLanes; ++i) y.high[i] = __builtin_sqrt(x.high[i]);
  return y;
}
inline PackPair root(const PackPair& x) {
  return {root(x.low), root(x.high)};
}

/// 1/sqrt(x) of normal numbers x > 0.
inline Register inverse_root(const Register& x) {
#if ORBEARING_REGISTER_LANES == 8
  Register y = __builtin_ia32_rsqrt14pd512_mask(x, Register{}, 0xff);
  const Register half = 0.5 * x;
  y = y * (1.5 - half * y * y);
  const Register miss = 1.0 - x * y * y;
  return y + y * miss * (0.5 + 0.375 * miss);
#else
  Register y;
  for (int i = 0; i < kRegisterLanes; ++i) y[i] = __builtin_sqrt(x[i]);
  return 1.0 / y;
#endif
}
template <class Part>
inline Two<Part> inverse_root(const Two<Part>& x) {
  return {inverse_root(x.low), inverse_root(x.high)};
}

}  // namespace orbearing::mechanics::ORBEARING_PACKS
