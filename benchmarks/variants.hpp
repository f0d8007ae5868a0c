// Possible saving of many variants side by side, one in each lane of a vector register, over one after the
// other.
#pragma once

#include <nlohmann/json.hpp>

namespace orbearing::bench {

/// Measurements for lanes of variants (README.md here): the fixed part of a step's cost compared with that of
/// a pack of rollers, and the steps that neighbouring variants require separately, with one common step, and
/// in lanes with steps of their own. Prints its progress on standard error.
nlohmann::ordered_json measure_variants();

}  // namespace orbearing::bench
