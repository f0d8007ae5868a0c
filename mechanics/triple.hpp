// Vectors in space of any number type, plain numbers and packs alike. No header of a library here, and always
// inlined: files compiled for special instruction sets include it and must not leave a copy.
#pragma once

#include "mechanics/numbers.hpp"

namespace orbearing::mechanics {

/// Three components in a right-handed system of axes.
template <class Number>
struct Triple {
  Number x{}, y{}, z{};
};

template <class A, class B>
[[gnu::always_inline]] inline auto dot(const Triple<A>& a, const Triple<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
[[gnu::always_inline]] inline auto cross(const Triple<A>& a, const Triple<B>& b) {
  using Number = decltype(a.x * b.x);
  return Triple<Number>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator+(const Triple<A>& a, const Triple<B>& b) {
  using Number = decltype(a.x + b.x);
  return Triple<Number>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator-(const Triple<A>& a, const Triple<B>& b) {
  using Number = decltype(a.x - b.x);
  return Triple<Number>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A>
[[gnu::always_inline]] inline Triple<A> operator-(const Triple<A>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class A>
[[gnu::always_inline]] inline Triple<A>& operator+=(Triple<A>& a, const Triple<A>& b) {
  return a = a + b;
}
/// `factor` times `a`.
template <class Factor, class A>
[[gnu::always_inline]] inline auto scaled(const Factor& factor, const Triple<A>& a) {
  using Number = decltype(factor * a.x);
  return Triple<Number>{factor * a.x, factor * a.y, factor * a.z};
}

}  // namespace orbearing::mechanics
