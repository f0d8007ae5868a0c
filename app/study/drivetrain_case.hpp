// From a resolved case to the parameters of a drivetrain, and what the case should be told about them.
#pragma once

#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::app {

/// Parameters of a case of the model planetary-drivetrain.
study::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& resolved);

/// Parameters of the bearing alone, for both models that hold one.
bearing::CylindricalRollerBearing bearing_of(const ResolvedCase& resolved);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> derived_quantities(const study::PlanetaryDrivetrain& drivetrain,
                                        const study::DrivetrainGeometry& geometry);

/// Remarks on the gears, each with its place in the case.
std::vector<std::string> gear_warnings(const study::DrivetrainGeometry& geometry);

}  // namespace orbearing::app
