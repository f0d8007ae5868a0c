// Numbers in JSON, which knows no infinity.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace orbearing::app {

/// null where `value` is not finite.
inline nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace orbearing::app
