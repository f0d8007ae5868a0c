// Powers that the contact laws need, without logarithm and exponential.
#pragma once

#include "bearing/fast/lane_math.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// x^power to some per cent, from the bits of `x` > 0, which are nearly its logarithm.
inline Pack rough_power(const Pack& x, double power) {
  constexpr long long kOne = 0x3ff0000000000000LL;
  const Pack exponent = detail::whole_numbers(bits_of(x) - bits(kOne), 32);
  return from_bits((detail::nearest(exponent * power) << 32) + bits(kOne));
}

/// x^(1/9) for x >= 0, relative error below 1e-15; far below 1e-200 the root of that number. From a rough
/// z = x^(-1/9) by z <- z (1 - r)^(-1/9), r = 1 - x z^9, in powers of r: no division.
inline Pack ninth_root(const Pack& x) {
  constexpr double c1 = 1.0 / 9, c2 = c1 * 10 / 18, c3 = c2 * 19 / 27, c4 = c3 * 28 / 36, c5 = c4 * 37 / 45,
                   c6 = c5 * 46 / 54, c7 = c6 * 55 / 63;
  constexpr double kMiddle = 0.9676;  // the rough power is never too small: |r| < 0.35 about the middle
  const Pack safe = larger(x, spread(1e-200));
  Pack z = kMiddle * rough_power(safe, -c1);
  Pack z2 = z * z, z4 = z2 * z2;
  const Pack r = 1.0 - (safe * z) * (z4 * z4), r2 = r * r;
  z = z * ((1.0 + c1 * r) + r2 * ((c2 + c3 * r) + r2 * ((c4 + c5 * r) + r2 * (c6 + c7 * r))));
  z2 = z * z, z4 = z2 * z2;
  const Pack z8 = z4 * z4, root = safe * z8, t = 1.0 - root * z;
  // x z^8 with z (1 - t)^(-1/9): the root is root (1 - t)^(-8/9).
  return root * (1.0 + t * (8.0 / 9 + t * (68.0 / 81 + t * (1768.0 / 2187))));
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
