// Elementary functions of a pack of numbers. Relative error below 4e-16 in the ranges named.
#pragma once

#include "mechanics/packs/sums.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

namespace detail {
inline constexpr double kRounder = 0x1.8p52;  // adding it rounds a small number to a whole one
/// Signed whole numbers below 2^51 after a shift to the right, as floating-point numbers.
template <class Bits>
inline auto whole_numbers(const Bits& x, int shift) {
  return from_bits(plus_bits(x >> shift, 0x4338000000000000LL)) - kRounder;
}
/// Nearest whole numbers of |x| < 2^51.
template <class Number>
inline auto nearest(const Number& x) {
  return plus_bits(bits_of(x + kRounder), -0x4338000000000000LL);
}
}  // namespace detail

/// Natural logarithm of normal numbers > 0: ln x = k ln 2 + 2 artanh((m - 1)/(m + 1)), sqrt(1/2) <= m <
/// sqrt(2).
template <class Number>
inline Number logarithm(const Number& x) {
  constexpr long long kHalfRoot = 0x3fe6a09e667f3bcdLL;  // of sqrt(1/2)
  const auto shifted = plus_bits(bits_of(x), -kHalfRoot);
  const auto exponent = shifted >> 52;
  const Number mantissa = from_bits(bits_of(x) - (exponent << 52));
  const Number whole = detail::whole_numbers(exponent, 0);
  const Number s = (mantissa - 1.0) / (mantissa + 1.0);
  const Number q = s * s;
  const Number even =
      1.0 / 3 + q * q * (1.0 / 7 + q * q * (1.0 / 11 + q * q * (1.0 / 15 + q * q * (1.0 / 19))));
  const Number odd =
      1.0 / 5 + q * q * (1.0 / 9 + q * q * (1.0 / 13 + q * q * (1.0 / 17 + q * q * (1.0 / 21))));
  const Number tail = q * (even + q * odd);
  return whole * 0x1.62e42fefa3800p-1 + (2.0 * s + (2.0 * s * tail + whole * 0x1.ef35793c76730p-45));
}

/// Exponential for -700 < x < 700.
template <class Number>
inline Number exponential(const Number& x) {
  const Number shifted = x * 0x1.71547652b82fep+0 + detail::kRounder;
  const Number whole = shifted - detail::kRounder;
  const Number r = (x - whole * 0x1.62e42fefa3800p-1) - whole * 0x1.ef35793c76730p-45;
  const Number r2 = r * r;
  const Number r4 = r2 * r2;
  const Number low = (1.0 + r) + r2 * (1.0 / 2 + r * (1.0 / 6));
  const Number middle = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
  const Number high = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
  const Number top = 1.0 / 479001600 + r * (1.0 / 6227020800.0);
  const Number y = low + r4 * (middle + r4 * (high + r4 * top));
  return from_bits(bits_of(y) + (bits_of(shifted) << 52));
}

/// 1 with the sign of `x`.
template <class Part>
inline Two<Part> sign_of(const Two<Part>& x) {
  return with_sign_of(spread<Two<Part>>(1.0), x);
}

/// Angle of the vector (x, y), y > 0: between 0 and pi. By arctan t = pi/6 + arctan((t - c)/(1 + c t)), c =
/// tan(pi/6), the series is evaluated at most at tan(pi/12).
template <class Number>
inline Number angle_of(const Number& y, const Number& x) {
  constexpr double kPi = 0x1.921fb54442d18p+1;
  constexpr double kMiddle = 0x1.279a74590331cp-1;  // tan(pi/6)
  constexpr double kFar = 0x1.126145e9ecd56p-2;     // tan(pi/12)
  const Number size = absolute(x);
  const auto steep = y > size;
  const Number least = select(steep, size, y), most = select(steep, y, size);
  const auto far = least > kFar * most;
  const Number t = select(far, least - kMiddle * most, least) / select(far, most + kMiddle * least, most);
  const Number q = t * t, q2 = q * q;
  const Number odd =
      -1.0 / 3 + q2 * (-1.0 / 7 + q2 * (-1.0 / 11 + q2 * (-1.0 / 15 + q2 * (-1.0 / 19 - q2 * (1.0 / 23)))));
  const Number even =
      1.0 / 5 + q2 * (1.0 / 9 + q2 * (1.0 / 13 + q2 * (1.0 / 17 + q2 * (1.0 / 21 + q2 * (1.0 / 25)))));
  const Number low = t + t * q * (odd + q * even) + only(far, spread<Number>(kPi / 6));
  const Number first = select(steep, kPi / 2 - low, low);
  return select(x < 0.0, kPi - first, first);
}

template <class Number>
struct SaturationOf {
  Number value, slope;
};

/// sign(x) (1 - exp(-|x|)) with its slope exp(-|x|).
template <class Number>
inline SaturationOf<Number> saturation(const Number& x) {
  const Number size = absolute(x);
  const Number decay = exponential(-smaller(size, spread<Number>(600.0)));
  // 1 - exp(-x) loses digits for small x; there its series.
  const Number series =
      size *
      (1.0 - size * (0.5 - size * (1.0 / 6 -
                                   size * (1.0 / 24 -
                                           size * (1.0 / 120 - size * (1.0 / 720 - size * (1.0 / 5040)))))));
  return {with_sign_of(select(size < 1e-2, series, 1.0 - decay), x), decay};
}

struct SineCosine {
  Pack sine;
  Pack cosine;
};

/// Sine and cosine for |x| < 1e8.
inline SineCosine sine_cosine(const Pack& x) {
  const Pack shifted = x * 0x1.45f306dc9c883p-1 + detail::kRounder;
  const Pack whole = shifted - detail::kRounder;
  const Pack r =
      ((x - whole * 0x1.921fb54400000p+0) - whole * 0x1.0b4611a600000p-34) - whole * 0x1.3198a2e037073p-69;
  const Pack q = r * r;
  const Pack sine_tail =
      -1.0 / 6 +
      q * (1.0 / 120 + q * (-1.0 / 5040 +
                            q * (1.0 / 362880 + q * (-1.0 / 39916800 + q * (1.0 / 6227020800.0 +
                                                                            q * (-1.0 / 1307674368000.0))))));
  const Pack cosine_tail =
      1.0 / 24 +
      q * (-1.0 / 720 + q * (1.0 / 40320 + q * (-1.0 / 3628800 +
                                                q * (1.0 / 479001600 + q * (-1.0 / 87178291200.0 +
                                                                            q * (1.0 / 20922789888000.0))))));
  const Pack s = r + r * q * sine_tail;
  const Pack c = 1.0 - 0.5 * q + q * q * cosine_tail;
  const Mask quadrant = bits_of(shifted);
  const Mask odd = -(quadrant & bits(1));
  const Mask sine_negative = (quadrant & bits(2)) << 62;
  const Mask cosine_negative = ((quadrant + bits(1)) & bits(2)) << 62;
  return {from_bits(bits_of(select(odd, c, s)) ^ sine_negative),
          from_bits(bits_of(select(odd, s, c)) ^ cosine_negative)};
}

}  // namespace orbearing::mechanics::ORBEARING_PACKS
