// How the planets of a set share its mean load where pins stand off their places.
#pragma once

#include <vector>

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// Share [-] of each planet in the mean load of the meshes, 1 where all carry alike; negative where the
/// planet is driven on its back flanks. Static balance of the gears at their mean mesh stiffness, with teeth
/// that part, on bearings that give way as their quasi-static loads say, each on the support of its pin.
/// @throws std::runtime_error where no balance is found, std::invalid_argument where the drivetrain has no
/// gears that can move
std::vector<double> load_shares(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

/// Duty of one bearing of each planet; a single one where all planets carry alike.
std::vector<BearingDuty> planet_duties(const PlanetaryDrivetrain& drivetrain,
                                       const DrivetrainGeometry& geometry);

}  // namespace orbearing::study
