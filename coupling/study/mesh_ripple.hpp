// From the motion of the gears to what their meshes add to the mean load on a planet bearing.
#pragma once

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// Harmonics of the load of both meshes on the bore of one bearing, of the planet of `duty`, at the
/// drivetrain's power and speed: Eqs. (19) and (20) of gearset/README.md with the mesh forces in time, less
/// their mean. The gears move on springs in place of the rollers. None where the drivetrain has no
/// `gear_set`, or no mesh variation.
/// @throws std::runtime_error where the gears' motion cannot be computed
bearing::dynamics::MeshRipple mesh_ripple(const PlanetaryDrivetrain& drivetrain,
                                          const DrivetrainGeometry& geometry, const BearingDuty& duty);

}  // namespace orbearing::study
