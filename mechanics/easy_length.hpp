// Lengths of signals that transform fast.
#pragma once

namespace orbearing::mechanics {

/// The largest number up to `most` (at least 1) without a prime factor beyond 5. Fourier transforms of such a
/// length take moments, those of a prime length of 100,000 minutes.
constexpr long easy_length_within(long most) {
  for (long length = most;; --length) {
    long rest = length;
    for (const long factor : {2L, 3L, 5L})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

}  // namespace orbearing::mechanics
