// A warning about the gear set, tied to the input that it concerns.
#pragma once

#include <string>
#include <vector>

namespace orbearing::gearset {

/// What was found and what it means or asks for; `key` is that of the case file, such as "gearset.teeth".
struct Warning {
  std::string key;
  std::string text;
};

using Warnings = std::vector<Warning>;

}  // namespace orbearing::gearset
