// Numbers as results and messages have them: equal on every machine and in every language.
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace orbearing::mechanics {

/// `value` as "%.Ng" writes it with N = `digits`.
inline std::string significant(double value, int digits) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

/// `value` with so many digits after the point.
inline std::string with_decimals(double value, int digits) {
  char text[400];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr};
}

/// `value` in a unit of which `per_unit` make one of its own, without the last bits, which the conversion may
/// touch. Not a number where either is not finite.
inline double in_unit(double value, double per_unit) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(value)) return none;
  if (per_unit == 1.0) return value;
  constexpr int digits_after_first = 14;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value * per_unit, std::chars_format::scientific,
                                 digits_after_first)
                       .ptr;
  double rounded = none;
  std::from_chars(text, end, rounded);
  return std::isfinite(rounded) ? rounded : none;
}

}  // namespace orbearing::mechanics
