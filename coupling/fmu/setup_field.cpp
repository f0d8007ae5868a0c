#include "coupling/fmu/setup_field.hpp"

#include <cmath>
#include <stdexcept>

namespace orbearing::fmu {

void require_allowed(const FieldFacts& facts, double value) {
  const char* required = nullptr;
  if (!std::isfinite(value)) required = "a finite number";
  if (facts.allowed == Allowed::not_negative && !(value >= 0.0)) required = "not less than 0";
  if (facts.allowed == Allowed::positive && !(value > 0.0)) required = "greater than 0";
  if (facts.allowed == Allowed::share && !(value >= 0.0 && value <= 1.0)) required = "from 0 to 1";
  if (required != nullptr)
    throw std::invalid_argument(facts.name + ": found " + std::to_string(value) + " " + facts.unit +
                                "; required: " + required);
}

}  // namespace orbearing::fmu
