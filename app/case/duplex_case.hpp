// From a resolved case of the model duplex-pair to a pair of bearings on a shaft.
#pragma once

#include <optional>

#include "app/case/resolved_case.hpp"
#include "bearing/duplex/shaft.hpp"

namespace orbearing::app {

/// Either bearing of the pair.
bearing::Bearing duplex_bearing_of(const ResolvedCase& resolved);

bearing::duplex::Arrangement arrangement_of_pair(const ResolvedCase& resolved);
bool is_linear_pair(const ResolvedCase& resolved);

/// Approach [m] of each row by preload and spacers.
double pair_approach_of(const ResolvedCase& resolved, const bearing::Bearing& bearing);

/// How the shaft and its balls turn.
bearing::equilibrium::RowMotion pair_motion_of(const ResolvedCase& resolved);

/// Constants of the shaft for the nonlinear pair, and those for the linear formulas: each of the latter is
/// that of the shaft where the case states no other.
bearing::duplex::Shaft duplex_shaft_of(const ResolvedCase& resolved);
bearing::duplex::Shaft linear_shaft_of(const ResolvedCase& resolved);
std::optional<bearing::duplex::Housing> housing_of(const ResolvedCase& resolved);
/// Adds what is wrong; nothing for cases of other models.
void check_duplex(CheckedCase& resolved);

}  // namespace orbearing::app
