// Warnings that follow from the inputs of a drivetrain: assumptions, and effects that are left out. Each
// begins with the key of the case that it concerns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/set_keys.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/stated_geometry.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::analysis {

/// Cages in motion without a land: nothing but rollers holds them.
std::vector<std::string> cage_warnings(const std::vector<NamedSet>& sets);

/// Assumptions of a clearance before mounting: fits or temperatures that are not stated.
std::vector<std::string> clearance_warnings(const std::vector<NamedSet>& sets);

/// The moment by which helical teeth overturn the planets of sets whose tilt is not computed, and what it
/// would be on their bearings.
std::vector<std::string> overturning_warnings(const std::vector<NamedSet>& sets);

/// Slopes of the lead beside a computed tilt, in which the moment that they make is left out. Texts follow
/// the value.
mechanics::Problems slope_warnings(const PlanetaryDrivetrain& drivetrain);

/// Effects that the motion of helical gears leaves out.
std::vector<std::string> planar_warnings();

/// Teeth of all sets, the signs of their rings' shifts, and sets that are idle.
std::vector<std::string> gear_warnings(const StatedDrivetrain& drivetrain);

/// Too few laminae to resolve a profile or a tilt; then fewer than ISO/TS 16281 requires for its lives.
std::vector<std::string> lamina_warnings(const std::vector<NamedSet>& sets);

/// Rims softer than that of the longest life: a stiffer one is tried at the sets' own speed and power.
std::vector<std::string> soft_rim_warnings(const std::vector<NamedSet>& sets);

/// [m/s2]  The larger of the inertial fields of the carrier at the planets and of the rollers' own orbit.
double inertial_field(const NamedSet& set);

}  // namespace orbearing::analysis
