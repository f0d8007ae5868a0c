// From a resolved case to the parameters of a drivetrain, and warnings about its teeth.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::app {

/// Parameters of a case of the model planetary-drivetrain that has one set, without the dynamic model of its
/// gears, which itself follows from them: drivetrain_of() adds it.
study::PlanetaryDrivetrain drivetrain_without_gear_set(const ResolvedCase& resolved);

/// Warnings of the gears, each with its place in the case; sets without bearings included.
std::vector<std::string> gear_warnings(const ResolvedCase& resolved);

/// Whether some set has helical teeth.
bool is_helical(const ResolvedCase& resolved);

/// What motion of helical gears leaves out.
std::vector<std::string> planar_warnings(const ResolvedCase& resolved);

}  // namespace orbearing::app
