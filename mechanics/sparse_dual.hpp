// A number with its slopes by a few variables: forward differentiation of laws that are written once, as
// templates on their number type. Which slopes there are is part of the type, so that those that vanish cost
// nothing; the number itself is a double or a pack. Its slopes are of the same type, or each is several of
// them side by side: those of a double by many variables fill a register (packs/register_dual.hpp).
#pragma once

#include "mechanics/numbers.hpp"

namespace orbearing::mechanics {

/// Value and slopes by the variables whose bits are set in `kVariables`.
template <unsigned kVariables, class Number, class Slope = Number>
struct SparseDual {
  Number value;
  Slope slope[__builtin_popcount(kVariables)];

  static constexpr bool depends(int variable) { return (kVariables >> variable & 1u) != 0; }
  static constexpr int index(int variable) { return __builtin_popcount(kVariables & ((1u << variable) - 1)); }

  /// Slope by `variable`.
  template <int variable>
  Slope by() const {
    if constexpr (depends(variable))
      return slope[index(variable)];
    else
      return Slope{};
  }
};

template <class T>
inline constexpr bool is_dual = false;
template <unsigned kVariables, class Number, class Slope>
inline constexpr bool is_dual<SparseDual<kVariables, Number, Slope>> = true;
/// A number that does not change: a double, a pack, a pair of numbers.
template <class T>
concept Fixed = !is_dual<T>;

/// The variable number `index` itself.
template <int index, class Number>
SparseDual<(1u << index), Number> variable(const Number& x) {
  return {x, {Number{} + 1.0}};
}

namespace detail {
// Slope by one variable of a function whose slopes by its two arguments are what the functions say.
template <int v, unsigned a, unsigned b, class Number, class Slope, class ByX, class ByY>
void combine_one(const SparseDual<a, Number, Slope>& x, const SparseDual<b, Number, Slope>& y,
                 const ByX& by_x, const ByY& by_y, SparseDual<a | b, Number, Slope>& z) {
  using Z = SparseDual<a | b, Number, Slope>;
  constexpr bool in_x = (a >> v & 1u) != 0, in_y = (b >> v & 1u) != 0;
  if constexpr (in_x && in_y)
    z.slope[Z::index(v)] = by_x(x.template by<v>()) + by_y(y.template by<v>());
  else if constexpr (in_x)
    z.slope[Z::index(v)] = by_x(x.template by<v>());
  else if constexpr (in_y)
    z.slope[Z::index(v)] = by_y(y.template by<v>());
}
// Slopes of the number where `where` holds, else zero.
template <class Mask, class Slope>
Slope slope_where(const Mask& where, const Slope& slope) {
  return only(where, slope);
}
template <class Slope>
Slope slope_where(bool where, const Slope& slope) {
  return where ? slope : Slope{};
}
}  // namespace detail

/// A function of `x` and `y` with value `value`, linear in their slopes by the functions given.
template <unsigned a, unsigned b, class Number, class Slope, class ByX, class ByY>
SparseDual<a | b, Number, Slope> combined(const SparseDual<a, Number, Slope>& x,
                                          const SparseDual<b, Number, Slope>& y, const Number& value,
                                          const ByX& by_x, const ByY& by_y) {
  static_assert((a | b) < 64, "variables 0 to 5");
  SparseDual<a | b, Number, Slope> z;
  z.value = value;
  detail::combine_one<0>(x, y, by_x, by_y, z);
  detail::combine_one<1>(x, y, by_x, by_y, z);
  detail::combine_one<2>(x, y, by_x, by_y, z);
  detail::combine_one<3>(x, y, by_x, by_y, z);
  detail::combine_one<4>(x, y, by_x, by_y, z);
  detail::combine_one<5>(x, y, by_x, by_y, z);
  return z;
}

/// A function of `x` with value `value` whose slopes are those of `x` after `change`.
template <unsigned a, class Number, class Slope, class Change>
SparseDual<a, Number, Slope> changed(const SparseDual<a, Number, Slope>& x, const Number& value,
                                     const Change& change) {
  SparseDual<a, Number, Slope> y;
  y.value = value;
  // Written out: a loop would keep the slopes in memory.
  constexpr int n = __builtin_popcount(a);
  if constexpr (n > 0) y.slope[0] = change(x.slope[0]);
  if constexpr (n > 1) y.slope[1] = change(x.slope[1]);
  if constexpr (n > 2) y.slope[2] = change(x.slope[2]);
  if constexpr (n > 3) y.slope[3] = change(x.slope[3]);
  if constexpr (n > 4) y.slope[4] = change(x.slope[4]);
  if constexpr (n > 5) y.slope[5] = change(x.slope[5]);
  return y;
}

/// A function of `x` with value `value` and derivative `by_x`.
template <unsigned a, class Number, class Slope>
SparseDual<a, Number, Slope> chained(const SparseDual<a, Number, Slope>& x, const Number& value,
                                     const Number& by_x) {
  return changed(x, value, [&](const Slope& s) { return by_x * s; });
}

template <unsigned a, unsigned b, class Number, class Slope>
auto operator+(const SparseDual<a, Number, Slope>& x, const SparseDual<b, Number, Slope>& y) {
  const auto same = [](const Slope& s) { return s; };
  return combined(x, y, x.value + y.value, same, same);
}
template <unsigned a, unsigned b, class Number, class Slope>
auto operator-(const SparseDual<a, Number, Slope>& x, const SparseDual<b, Number, Slope>& y) {
  return combined(
      x, y, x.value - y.value, [](const Slope& s) { return s; }, [](const Slope& s) { return -s; });
}
template <unsigned a, unsigned b, class Number, class Slope>
auto operator*(const SparseDual<a, Number, Slope>& x, const SparseDual<b, Number, Slope>& y) {
  return combined(
      x, y, x.value * y.value, [&](const Slope& s) { return s * y.value; },
      [&](const Slope& s) { return x.value * s; });
}
template <unsigned a, unsigned b, class Number, class Slope>
auto operator/(const SparseDual<a, Number, Slope>& x, const SparseDual<b, Number, Slope>& y) {
  const Number inverse = 1.0 / y.value, value = x.value * inverse;
  return combined(
      x, y, value, [&](const Slope& s) { return s * inverse; },
      [&](const Slope& s) { return -value * inverse * s; });
}
template <unsigned a, class Number, class Slope>
auto operator-(const SparseDual<a, Number, Slope>& x) {
  return changed(x, -x.value, [](const Slope& s) { return -s; });
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator+(const SparseDual<a, Number, Slope>& x, const Constant& c) {
  return changed(x, Number(x.value + c), [](const Slope& s) { return s; });
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator+(const Constant& c, const SparseDual<a, Number, Slope>& x) {
  return x + c;
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator-(const SparseDual<a, Number, Slope>& x, const Constant& c) {
  return changed(x, Number(x.value - c), [](const Slope& s) { return s; });
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator-(const Constant& c, const SparseDual<a, Number, Slope>& x) {
  return changed(x, Number(c - x.value), [](const Slope& s) { return -s; });
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator*(const SparseDual<a, Number, Slope>& x, const Constant& c) {
  return changed(x, Number(x.value * c), [&](const Slope& s) { return s * c; });
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator*(const Constant& c, const SparseDual<a, Number, Slope>& x) {
  return x * c;
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto operator/(const Constant& c, const SparseDual<a, Number, Slope>& x) {
  const Number inverse = 1.0 / x.value, value = c * inverse;
  return chained(x, value, Number(-value * inverse));
}

template <unsigned a, class Number, class Slope>
auto exponential(const SparseDual<a, Number, Slope>& x) {
  const Number y = exponential(x.value);
  return chained(x, y, y);
}
template <unsigned a, class Number, class Slope>
auto logarithm(const SparseDual<a, Number, Slope>& x) {
  return chained(x, logarithm(x.value), Number(1.0 / x.value));
}
template <unsigned a, class Number, class Slope>
auto root(const SparseDual<a, Number, Slope>& x) {
  const Number y = root(x.value);
  return chained(x, y, Number(0.5 / y));
}

template <unsigned a, class Number, class Slope>
auto inverse_root(const SparseDual<a, Number, Slope>& x) {
  const Number y = inverse_root(x.value);
  return chained(x, y, Number(-0.5 * y * y * y));
}
template <unsigned a, class Number, class Slope>
auto arc_tangent(const SparseDual<a, Number, Slope>& x) {
  return chained(x, arc_tangent(x.value), Number(1.0 / (1.0 + x.value * x.value)));
}
/// Angle of the vector (x, y).
template <unsigned a, unsigned b, class Number, class Slope>
auto angle_of(const SparseDual<a, Number, Slope>& y, const SparseDual<b, Number, Slope>& x) {
  const Number inverse = 1.0 / (x.value * x.value + y.value * y.value);
  const Number by_y = x.value * inverse, by_x = -y.value * inverse;
  return combined(
      y, x, angle_of(y.value, x.value), [&](const Slope& s) { return by_y * s; },
      [&](const Slope& s) { return by_x * s; });
}

/// x / sqrt(x^2 + scale^2): the sign of `x`, rounded over `scale`.
template <class Number, class Scale>
auto rounded_sign(const Number& x, const Scale& scale) {
  if constexpr (is_dual<Number>) {
    const Scale square = scale * scale;
    const auto inverse = inverse_root(x.value * x.value + square);
    return chained(x, x.value * inverse, inverse * inverse * inverse * square);
  } else {
    return x * inverse_root(x * x + scale * scale);
  }
}

/// sign(x) (1 - exp(-|x|)).
template <class Number>
auto saturated(const Number& x) {
  if constexpr (is_dual<Number>) {
    const auto y = saturation(x.value);
    return chained(x, y.value, y.slope);
  } else {
    return saturation(x).value;
  }
}

/// Selection between numbers with slopes: value and slopes of the selected one.
template <class Mask, unsigned a, unsigned b, class Number, class Slope>
auto select(const Mask& where, const SparseDual<a, Number, Slope>& yes,
            const SparseDual<b, Number, Slope>& no) {
  return combined(
      yes, no, select(where, yes.value, no.value),
      [&](const Slope& s) { return detail::slope_where(where, s); },
      [&](const Slope& s) { return detail::slope_where(~where, s); });
}
template <unsigned a, unsigned b, class Number, class Slope>
auto select(bool where, const SparseDual<a, Number, Slope>& yes, const SparseDual<b, Number, Slope>& no) {
  return combined(
      yes, no, select(where, yes.value, no.value),
      [&](const Slope& s) { return detail::slope_where(where, s); },
      [&](const Slope& s) { return detail::slope_where(!where, s); });
}
template <class Mask, unsigned a, class Number, class Slope>
auto only(const Mask& where, const SparseDual<a, Number, Slope>& x) {
  return changed(x, only(where, x.value), [&](const Slope& s) { return detail::slope_where(where, s); });
}

/// A number without its slopes.
template <class Number>
const Number& value_of(const Number& x) {
  return x;
}
template <unsigned a, class Number, class Slope>
const Number& value_of(const SparseDual<a, Number, Slope>& x) {
  return x.value;
}

/// The larger and the smaller of two numbers one of which may have slopes the other lacks.
template <class X, class Y>
requires(is_dual<X>&& is_dual<Y>) auto larger(const X& x, const Y& y) {
  return select(x.value > y.value, x, y);
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto larger(const SparseDual<a, Number, Slope>& x, const Constant& c) {
  const Number limit = Number{} + c;
  const auto above = x.value > limit;
  return changed(x, select(above, x.value, limit),
                 [&](const Slope& s) { return detail::slope_where(above, s); });
}
template <unsigned a, class Number, class Slope, Fixed Constant>
auto smaller(const SparseDual<a, Number, Slope>& x, const Constant& c) {
  const Number limit = Number{} + c;
  const auto below = x.value < limit;
  return changed(x, select(below, x.value, limit),
                 [&](const Slope& s) { return detail::slope_where(below, s); });
}

template <class Y, Fixed Constant>
requires(is_dual<Y>) auto larger(const Constant& c, const Y& y) {
  return larger(y, c);
}
template <class X, class Y>
requires(is_dual<X>&& is_dual<Y>) auto smaller(const X& x, const Y& y) {
  return select(x.value < y.value, x, y);
}
template <class Y, Fixed Constant>
requires(is_dual<Y>) auto smaller(const Constant& c, const Y& y) {
  return smaller(y, c);
}

/// `value` with the slopes of `x`.
template <Fixed Number>
Number with_value(const Number&, const Number& value) {
  return value;
}
template <unsigned a, class Number, class Slope>
auto with_value(const SparseDual<a, Number, Slope>& x, const Number& value) {
  return changed(x, value, [](const Slope& s) { return s; });
}

}  // namespace orbearing::mechanics
