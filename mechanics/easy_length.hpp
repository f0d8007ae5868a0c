// Lengths of signals that transform fast.
#pragma once

namespace orbearing::mechanics {

/// Whether `length` (at least 1) has no prime factor beyond 5. Fourier transforms of such a length take moments,
/// those of a prime length of 100,000 minutes.
constexpr bool is_easy_length(long length) {
  for (const long factor : {2L, 3L, 5L})
    while (length % factor == 0) length /= factor;
  return length == 1;
}

/// The largest such length up to `most` (at least 1).
constexpr long easy_length_within(long most) {
  while (!is_easy_length(most)) --most;
  return most;
}

/// The smallest such length from `least` (at least 1) on.
constexpr long easy_length_from(long least) {
  while (!is_easy_length(least)) ++least;
  return least;
}

}  // namespace orbearing::mechanics
