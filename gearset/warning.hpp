// A warning about the gear set, tied to the input that it concerns.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "mechanics/problem.hpp"

namespace orbearing::gearset {

// Numbers in messages to the user.

/// A number with a fixed count of decimals.
inline std::string decimal(double value, int decimals) {
  std::array<char, 400> text;  // holds every finite double in fixed notation
  const auto result = std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, decimals);
  return {text.data(), result.ptr};
}

/// A length as millimetres.
/// @param length [m]
inline std::string millimetres(double length) {
  return decimal(1e3 * length, 3) + " mm";
}

using Warning = mechanics::Problem;
using Warnings = mechanics::Problems;

}  // namespace orbearing::gearset
