// Meshes of a planetary set: stiffness over the mesh period, phases, and the standard beside it.
#pragma once

#include <vector>

#include "coupling/analysis/meshes.hpp"
#include "coupling/analysis/set_gears.hpp"
#include "gearset/stated_geometry.hpp"

namespace orbearing::analysis {

/// Meshes of a single set at its power and speed.
/// @param stated values of a drawing, without which a negative shift of the ring is warned of
MeshStudy meshes_of_set(const PlanetaryDrivetrain& drivetrain, const SetGears& gears,
                        const gearset::StatedGeometry& stated);

/// Circles of sun, planet and ring, and of the second gear of a stepped planet.
std::vector<GearCircles> gear_circles(const gearset::WorkingGeometry& geometry);

}  // namespace orbearing::analysis
