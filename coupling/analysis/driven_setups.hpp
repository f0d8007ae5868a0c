// From a drivetrain to its gear set and its planet bearings as driven participants.
#pragma once

#include "coupling/analysis/drivetrain.hpp"
#include "coupling/system/coupled_model.hpp"

namespace orbearing::analysis {

/// One bearing of one planet. The planet's mass belongs to the gears; the bearing uses its share only for the
/// damping of the pin's support.
system::DrivenBearingSetup driven_bearing_setup(const PlanetaryDrivetrain& drivetrain,
                                                const DrivetrainGeometry& geometry);

/// The set with all bearings left to others, at the drivetrain's power and speed; at mean mesh stiffness
/// where the drivetrain has no mesh variation. Among several sets the shafts to the others keep their
/// torques, that by which most power enters keeps this power: shafts that are soft in torsion compared with
/// the meshes.
/// @throws std::invalid_argument where the drivetrain has no gears that can move, or where the housing does
/// not hold its `set.fixed_member`
system::DrivenGearsSetup driven_gears_setup(const PlanetaryDrivetrain& drivetrain);

/// Both, with all bearings of all planets; where their tilt is computed, on their seats at rest.
system::CoupledSetup coupled_setup(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

}  // namespace orbearing::analysis
