// Masses, inertias and stiffnesses of the gears of a planetary set, as their dynamics has them.
#pragma once

#include <optional>
#include <string>

#include "coupling/analysis/set_gears.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Where the planet bearings have no stiffness, e.g. without contact, the other quantities are those with any
/// other spring instead.
struct GearQuantities {
  std::optional<gearset::dynamics::SetModel> model;  // none: not computed
  std::string failure{};                             // why the stiffness of the bearings is not computed
  std::string failure_without_bearings{};            // why the others are not
};

/// Throws std::domain_error where a gear has no body under its teeth.
GearQuantities gear_quantities(const PlanetaryDrivetrain& drivetrain, const SetGears& gears);

/// Under the keys of the inputs that replace them.
void describe(described::Record& record, const GearQuantities& of);

}  // namespace orbearing::analysis
