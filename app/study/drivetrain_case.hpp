// Warnings of the gears of a resolved case, and the life by which its bearings are judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/rating_lives.hpp"

namespace orbearing::app {

/// Warnings of the gears, each with its place in the case; sets without bearings included.
std::vector<std::string> gear_warnings(const ResolvedCase& resolved);

/// Effects that the motion of helical gears leaves out.
std::vector<std::string> planar_warnings(const ResolvedCase& resolved);

// The oil and its cleanliness as a case states them, for the modified life of ISO 281.

/// None where neither oil nor cleanliness is stated: then lives have no a_ISO.
std::optional<bearing::rating::StatedOil> stated_oil(const ResolvedCase& resolved);

/// Assumptions of lives, e.g. a cleanliness that is not stated; and a requirement of another life than the
/// governing one.
std::vector<std::string> rating_warnings(const ResolvedCase& resolved);

/// How the governing life is computed, by life.method.
bearing::rating::LifeMethod life_method(const ResolvedCase& resolved);

/// The governing life of the bearings of a case: by life.method, and whether oil is stated.
bearing::rating::Life governing_life(const ResolvedCase& resolved);
/// Its key in hours: L10h, L10rh, L10mh, L10mrh or life_h.
std::string governing_life_key(const ResolvedCase& resolved);

}  // namespace orbearing::app
