// From a resolved case to the parameters of a drivetrain, and warnings about its teeth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/life/life_modification.hpp"
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

// The oil and its cleanliness as a case states them, for the modified life of ISO 281.

/// None where neither oil nor cleanliness is said: then lives know no a_ISO.
std::optional<bearing::rating::StatedOil> stated_oil(const ResolvedCase& resolved);

/// What it takes for granted: a cleanliness that is not said.
std::vector<std::string> oil_warnings(const ResolvedCase& resolved);

/// Column of a sweep's table that holds the life that results go by: by life.method, and whether oil is
/// stated.
std::string life_to_go_by(const ResolvedCase& resolved);

}  // namespace orbearing::app
