// From a resolved case of the model duplex-pair to a pair of bearings on a shaft, and what was measured on
// it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/duplex/identification.hpp"
#include "bearing/duplex/shaft.hpp"

namespace orbearing::app {

/// Either bearing of the pair; one of its rows where `contact_angle` [rad] is given.
bearing::Bearing duplex_bearing_of(const ResolvedCase& resolved, std::optional<double> contact_angle = {});

bearing::duplex::Arrangement arrangement_of_pair(const ResolvedCase& resolved);
bool is_linear_pair(const ResolvedCase& resolved);

/// Approach [m] of each row by `preload` [N] and by the spacers that the case states.
double pair_approach_of(const ResolvedCase& resolved, const bearing::Bearing& bearing, double preload);

/// How the shaft and its balls turn.
bearing::equilibrium::RowMotion pair_motion_of(const ResolvedCase& resolved);

/// Constants of the shaft for the nonlinear pair, and those for the linear formulas: each of the latter is
/// that of the shaft where the case states no other.
bearing::duplex::Shaft duplex_shaft_of(const ResolvedCase& resolved);
bearing::duplex::Shaft linear_shaft_of(const ResolvedCase& resolved);
std::optional<bearing::duplex::Housing> housing_of(const ResolvedCase& resolved);
/// The shaft as a cylinder; none where it is not one.
std::optional<bearing::duplex::Cylinder> cylinder_of(const ResolvedCase& resolved);

/// Natural frequencies that were measured on one pair.
struct MeasuredPair {
  double contact_angle = 0.0;         // [rad]
  double preload = 0.0;               // [N]
  std::array<double, 5> frequency{};  // [Hz]  in the order of duplex::mode_kinds
};
std::vector<MeasuredPair> measured_pairs_of(const ResolvedCase& resolved);

/// Adds what is wrong; nothing for cases of other models.
void check_duplex(CheckedCase& resolved);

}  // namespace orbearing::app
