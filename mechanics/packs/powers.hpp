// Powers that the contact laws need, without logarithm and exponential.
#pragma once

#include "mechanics/packs/elementary.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

/// log2 x of `x` > 0 to 0.086 from below, from its bits, which are nearly its logarithm.
template <class Number>
inline Number rough_log2(const Number& x) {
  constexpr long long kOne = 0x3ff0000000000000LL;
  return 0x1p-20 * detail::whole_numbers(plus_bits(bits_of(x), -kOne), 32);
}

/// x^power to some per cent, of `x` > 0.
template <class Number>
inline Number rough_power(const Number& x, double power) {
  constexpr long long kOne = 0x3ff0000000000000LL;
  return from_bits(plus_bits(detail::nearest(rough_log2(x) * (0x1p20 * power)) << 32, kOne));
}

/// x^(1/9) for x >= 0, relative error below 1e-15; far below 1e-200 the root of that number. From a rough
/// z = x^(-1/9) by z <- z (1 - r)^(-1/9), r = 1 - x z^9, in powers of r: no division.
template <class Number>
inline Number ninth_root(const Number& x) {
  constexpr double c1 = 1.0 / 9, c2 = c1 * 10 / 18, c3 = c2 * 19 / 27, c4 = c3 * 28 / 36, c5 = c4 * 37 / 45,
                   c6 = c5 * 46 / 54, c7 = c6 * 55 / 63;
  constexpr double kMiddle = 0.9676;  // the rough power is never too small: |r| < 0.35 about the middle
  const Number safe = larger(x, spread<Number>(1e-200));
  Number z = kMiddle * rough_power(safe, -c1);
  Number z2 = z * z, z4 = z2 * z2;
  const Number r = 1.0 - (safe * z) * (z4 * z4), r2 = r * r;
  z = z * ((1.0 + c1 * r) + r2 * ((c2 + c3 * r) + r2 * ((c4 + c5 * r) + r2 * (c6 + c7 * r))));
  z2 = z * z, z4 = z2 * z2;
  const Number z8 = z4 * z4, root = safe * z8, t = 1.0 - root * z;
  // x z^8 with z (1 - t)^(-1/9): the root is root (1 - t)^(-8/9).
  return root * (1.0 + t * (8.0 / 9 + t * (68.0 / 81 + t * (1768.0 / 2187))));
}

}  // namespace orbearing::mechanics::ORBEARING_PACKS
