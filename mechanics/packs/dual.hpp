// A number with its derivatives by a few variables: forward differentiation of scalar laws.
#pragma once

#include "mechanics/packs/pack.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

/// Eight numbers, in as many registers as they take: a vector wider than a register goes through memory.
#if ORBEARING_REGISTER_LANES == 8
using SlopeVector = Register;
#elif ORBEARING_REGISTER_LANES == 4
using SlopeVector = Pack;
#else
using SlopeVector = Two<Pack>;
#endif

/// Value and slopes by `kVariables` variables, eight at most.
template <int kVariables>
struct Dual {
  static_assert(kVariables <= 8 && sizeof(SlopeVector) == 8 * sizeof(double));
  double value = 0.0;
  SlopeVector slope{};

  Dual() = default;
  explicit Dual(double number) : value(number) {}
  /// The variable number `index` itself.
  static Dual variable(double number, int index) {
    Dual x(number);
    reinterpret_cast<double*>(&x.slope)[index] = 1.0;
    return x;
  }
  /// Slope by the variable number `index`.
  double by(int index) const { return reinterpret_cast<const double*>(&slope)[index]; }
};

/// A function of `x` with value `value` and derivative `by_x`.
template <int n>
Dual<n> chained(const Dual<n>& x, double value, double by_x) {
  Dual<n> y(value);
  y.slope = by_x * x.slope;
  return y;
}

template <int n>
Dual<n> chained(const Dual<n>& x, const Dual<n>& y, double value, double by_x, double by_y) {
  Dual<n> z(value);
  z.slope = by_x * x.slope + by_y * y.slope;
  return z;
}

template <int n>
Dual<n> operator+(const Dual<n>& x, const Dual<n>& y) {
  return chained(x, y, x.value + y.value, 1.0, 1.0);
}
template <int n>
Dual<n> operator-(const Dual<n>& x, const Dual<n>& y) {
  return chained(x, y, x.value - y.value, 1.0, -1.0);
}
template <int n>
Dual<n> operator*(const Dual<n>& x, const Dual<n>& y) {
  return chained(x, y, x.value * y.value, y.value, x.value);
}
template <int n>
Dual<n> operator/(const Dual<n>& x, const Dual<n>& y) {
  const double inverse = 1.0 / y.value;
  return chained(x, y, x.value * inverse, inverse, -x.value * inverse * inverse);
}
template <int n>
Dual<n> operator-(const Dual<n>& x) {
  return chained(x, -x.value, -1.0);
}
template <int n>
Dual<n> operator+(const Dual<n>& x, double a) {
  return chained(x, x.value + a, 1.0);
}
template <int n>
Dual<n> operator+(double a, const Dual<n>& x) {
  return x + a;
}
template <int n>
Dual<n> operator-(double a, const Dual<n>& x) {
  return chained(x, a - x.value, -1.0);
}
template <int n>
Dual<n> operator-(const Dual<n>& x, double a) {
  return chained(x, x.value - a, 1.0);
}
template <int n>
Dual<n> operator*(double a, const Dual<n>& x) {
  return chained(x, a * x.value, a);
}
template <int n>
Dual<n> operator*(const Dual<n>& x, double a) {
  return a * x;
}
template <int n>
Dual<n> operator/(const Dual<n>& x, double a) {
  return (1.0 / a) * x;
}
template <int n>
Dual<n> operator/(double a, const Dual<n>& x) {
  return chained(x, a / x.value, -a / (x.value * x.value));
}

template <int n>
double value_of(const Dual<n>& x) {
  return x.value;
}

template <int n>
Dual<n> root(const Dual<n>& x) {
  const double root = __builtin_sqrt(x.value);
  return chained(x, root, 0.5 / root);
}

template <int n>
Dual<n> inverse_root(const Dual<n>& x) {
  const double inverse = 1.0 / __builtin_sqrt(x.value);
  return chained(x, inverse, -0.5 * inverse * inverse * inverse);
}
template <int n>
Dual<n> larger(const Dual<n>& x, double limit) {
  return x.value > limit ? x : Dual<n>(limit);
}

template <int n>
Dual<n> arc_tangent(const Dual<n>& x) {
  return chained(x, __builtin_atan(x.value), 1.0 / (1.0 + x.value * x.value));
}

}  // namespace orbearing::mechanics::ORBEARING_PACKS
