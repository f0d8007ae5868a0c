// Profiles of rollers and races as lists of numbers.
#pragma once

#include <vector>

#include "bearing/profile/profile.hpp"

namespace orbearing::fmu {

/// Place of the kind in the variant, then its members; a table as scale, places, drops.
std::vector<double> profile_numbers(const bearing::profile::Profile& profile);

/// Throws std::invalid_argument where `numbers` are those of no profile.
bearing::profile::Profile profile_from(const std::vector<double>& numbers);

}  // namespace orbearing::fmu
