// A force that a search for a balance leaves, as reports and messages state it: never NaN.
#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace orbearing::mechanics {

/// [N]  infinite where it is no number.
inline double force_left(double force) {
  return std::isnan(force) ? std::numeric_limits<double>::infinity() : force;
}

/// "3.2 N remain"
inline std::string force_left_text(double force) {
  if (!std::isfinite(force)) return "the forces are not finite";
  std::ostringstream text;
  text << force << " N remain";
  return text.str();
}

}  // namespace orbearing::mechanics
