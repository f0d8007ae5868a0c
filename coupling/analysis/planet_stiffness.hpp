// A planet whose rim bends: its meshes and its bearings as one spring.
#pragma once

#include <Eigen/Core>

#include "coupling/analysis/drivetrain.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::analysis {

/// Stiffness [N/m] of one planet with an elastic rim, linear about the quasi-static equilibrium at the
/// drivetrain's power and speed: forces by the deflections of its sun mesh, its ring mesh and its bearings
/// outward and in the sense of rotation, as gearset/dynamics has them. Rollers and pin supports follow
/// without mass, mean over the positions of the rollers. Eq. (6) of gearset/rim/README.md.
/// @param sun_mesh, ring_mesh [N/m] of the meshes on a planet whose bore is held
/// @throws std::runtime_error where the bearing has no equilibrium
Eigen::Matrix4d planet_stiffness(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 double sun_mesh, double ring_mesh);

// The planet bearings as springs and dampers about the mean load: data for modes and for single gear sets of
// them.

/// `like` in its mean over time, in which rollers and rotating races pass every position: with equal rollers
/// and stationary forms. At one position of the cage unlike ones would distort its law by their momentary
/// positions.
bearing::Bearing of_like_rollers(bearing::Bearing like);

/// All bearings of one planet with their pin supports, linear about their quasi-static equilibrium at the
/// drivetrain's power and speed: at the mean displacement they carry the mean load. Rollers and pin support
/// in series, the stiffness and the damping of each; mean over the positions of the rollers. Masses of
/// rollers and pin ring, friction, laminae, unlike rollers and waves that turn with a race are left out.
/// @throws std::runtime_error where the bearing has no equilibrium
gearset::dynamics::AffineBearing bearing_tangent(const PlanetaryDrivetrain& drivetrain,
                                                 const DrivetrainGeometry& geometry);

/// Radial stiffness [N/m] of the same along the mean load, for those who take it alike in all directions.
double planet_bearing_stiffness(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

}  // namespace orbearing::analysis
