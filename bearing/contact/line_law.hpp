// Elastic line contact, Q = K e^(10/9): the law once for plain numbers, packs and both with their slopes.
// Always inlined, and no header of a library: files compiled for special instruction sets include it.
#pragma once

namespace orbearing::bearing {

/// By the secant stiffness s = Q/e = K e^(1/9) [N/m] at an elastic approach e > 0, which packs have from a
/// ninth root without logarithm and exponential. Q is the load [N], K the constant [N/m^(10/9)].
struct LineLaw {
  static constexpr double kExponent = 10.0 / 9.0;          // of the load over the elastic approach
  static constexpr double kApproachExponent = 9.0 / 10.0;  // of the elastic approach over the load

  /// dQ/de [N/m].
  template <class Secant>
  [[gnu::always_inline]] static auto slope(const Secant& secant) {
    return kExponent * secant;
  }
  /// de/dQ [m/N].
  template <class Load, class Approach>
  [[gnu::always_inline]] static auto compliance(const Load& load, const Approach& approach) {
    return kApproachExponent * approach / load;
  }
  /// Stored energy [J].
  template <class Load, class Approach>
  [[gnu::always_inline]] static auto energy(const Load& load, const Approach& approach) {
    return (1.0 / (1.0 + kExponent)) * load * approach;
  }
  /// ln Q by ln e and ln K.
  template <class LogApproach, class LogConstant>
  [[gnu::always_inline]] static auto log_load(const LogApproach& log_approach,
                                              const LogConstant& log_constant) {
    return kExponent * log_approach + log_constant;
  }
  /// ln e by ln Q and ln K.
  template <class LogLoad, class LogConstant>
  [[gnu::always_inline]] static auto log_approach(const LogLoad& log_load, const LogConstant& log_constant) {
    return kApproachExponent * (log_load - log_constant);
  }
};

}  // namespace orbearing::bearing
