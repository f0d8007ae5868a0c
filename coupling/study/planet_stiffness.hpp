// A planet whose rim bends: its meshes and its bearings as one spring.
#pragma once

#include <Eigen/Core>

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// Stiffness [N/m] of one planet with an elastic rim, linear about the quasi-static balance at the
/// drivetrain's power and speed: forces by the deflections of its sun mesh, its ring mesh and its bearings
/// outward and in the sense of rotation, as gearset/dynamics has them. Rollers and pin supports follow
/// without mass, mean over the places of the rollers. Eq. (6) of gearset/rim/README.md.
/// @param sun_mesh, ring_mesh [N/m] of the meshes on a planet whose bore is held
/// @throws std::runtime_error where the bearing finds no balance
Eigen::Matrix4d planet_stiffness(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 double sun_mesh, double ring_mesh);

}  // namespace orbearing::study
