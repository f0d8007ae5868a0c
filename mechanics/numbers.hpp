// Elementary functions of plain numbers under the names that packs have them by (mechanics/packs), so that a
// law is written once for both. Always inlined: files compiled for special instruction sets must not leave a
// copy.
#pragma once

namespace orbearing::mechanics {

namespace detail {
template <class T>
struct PlainType {
  using type = T;
};
template <class T>
struct PlainType<const T> : PlainType<T> {};
template <class T>
struct PlainType<T&> : PlainType<T> {};
}  // namespace detail
/// A type without reference and const.
template <class T>
using Plain = typename detail::PlainType<T>::type;

#define ORBEARING_INLINE [[gnu::always_inline]] inline
ORBEARING_INLINE double exponential(double x) {
  return __builtin_exp(x);
}
/// Natural logarithm.
ORBEARING_INLINE double logarithm(double x) {
  return __builtin_log(x);
}
ORBEARING_INLINE double root(double x) {
  return __builtin_sqrt(x);
}
ORBEARING_INLINE double inverse_root(double x) {
  return 1.0 / __builtin_sqrt(x);
}
ORBEARING_INLINE double absolute(double x) {
  return __builtin_fabs(x);
}
struct PlainSineCosine {
  double sine, cosine;
};
ORBEARING_INLINE PlainSineCosine sine_cosine(double x) {
  return {__builtin_sin(x), __builtin_cos(x)};
}
/// Angle of the vector (x, y).
ORBEARING_INLINE double angle_of(double y, double x) {
  return __builtin_atan2(y, x);
}
ORBEARING_INLINE double arc_tangent(double x) {
  return __builtin_atan(x);
}
/// 1 with the sign of `x`.
ORBEARING_INLINE double sign_of(double x) {
  return __builtin_copysign(1.0, x);
}
ORBEARING_INLINE double larger(double a, double b) {
  return a > b ? a : b;
}
ORBEARING_INLINE double smaller(double a, double b) {
  return a < b ? a : b;
}
ORBEARING_INLINE double select(bool where, double yes, double no) {
  return where ? yes : no;
}
/// `x` where `where` holds, else zero.
ORBEARING_INLINE double only(bool where, double x) {
  return where ? x : 0.0;
}
ORBEARING_INLINE bool any(bool where) {
  return where;
}
/// sign(x) (1 - exp(-|x|)) with its slope exp(-|x|).
struct Saturation {
  double value, slope;
};
ORBEARING_INLINE Saturation saturation(double x) {
  return {__builtin_copysign(-__builtin_expm1(-__builtin_fabs(x)), x), __builtin_exp(-__builtin_fabs(x))};
}
#undef ORBEARING_INLINE

}  // namespace orbearing::mechanics
