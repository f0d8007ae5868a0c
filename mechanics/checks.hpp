// Arguments that a function cannot do anything sound with: refused in the same words everywhere.
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace orbearing::mechanics {

/// Throws std::invalid_argument: "what: found ...; required: ...". `what` names the argument and its unit.
template <class Value>
[[noreturn]] void refuse(std::string_view what, const Value& found, std::string_view required) {
  std::ostringstream text;
  text << what << ": found " << found << "; required: " << required;
  throw std::invalid_argument(text.str());
}

/// Refuses `found` unless `holds`. Write conditions so that NaN fails them.
template <class Value>
void require(bool holds, std::string_view what, const Value& found, std::string_view required) {
  if (!holds) refuse(what, found, required);
}

inline void require_positive(double value, std::string_view what) {
  require(std::isfinite(value) && value > 0.0, what, value, "a finite number greater than 0");
}

inline void require_not_negative(double value, std::string_view what) {
  require(std::isfinite(value) && value >= 0.0, what, value, "a finite number of at least 0");
}

}  // namespace orbearing::mechanics
