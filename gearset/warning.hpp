// A warning about the gear set, tied to the place in the case file that it concerns.
#pragma once

#include <string>
#include <vector>

namespace orbearing::gearset {

/// What was found and what it means or asks for; `place` is a key of the case file, such as "gearset.teeth".
struct Warning {
  std::string place;
  std::string text;
};

using Warnings = std::vector<Warning>;

}  // namespace orbearing::gearset
