// The oil and its cleanliness as a case states them, for the modified life of ISO 281.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/life/life_modification.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::app {

/// None where neither oil nor cleanliness is said: then lives know no a_ISO.
std::optional<bearing::rating::StatedOil> stated_oil(const ResolvedCase& resolved);

/// What it takes for granted: a cleanliness that is not said.
std::vector<std::string> oil_warnings(const ResolvedCase& resolved);

/// What the bearings of a set are rated by.
study::RatedBearing rated_bearing(const ResolvedCase& resolved);

/// Column of a sweep's table that holds the life that results go by: by life.method, and whether oil is stated.
std::string life_to_go_by(const ResolvedCase& resolved);

}  // namespace orbearing::app
