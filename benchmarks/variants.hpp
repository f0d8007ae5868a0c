// What many variants side by side, one in each lane of a vector register, could save over one after the
// other.
#pragma once

#include <nlohmann/json.hpp>

namespace orbearing::bench {

/// Measures what decides on lanes of variants (README.md here): the fixed part of a step's cost beside that
/// of a pack of rollers, and the steps that neighbouring variants need alone, with one common step, and in
/// lanes with steps of their own. Says on standard error what it is at.
nlohmann::ordered_json measure_variants();

}  // namespace orbearing::bench
