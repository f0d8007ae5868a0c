// Teeth under load of both meshes of a planetary set.
#pragma once

#include "gearset/mesh/loaded/tooth_pairs.hpp"
#include "gearset/mesh/planetary_meshes.hpp"

namespace orbearing::gearset {

struct SetTeeth {
  ToothPairs sun;
  ToothPairs ring;
};

/// With the modifications and the web of the set.
SetTeeth set_teeth(const PlanetarySet& set, const PlanetaryMeshes& meshes);

/// Whether edges touch under the force where the other gear has no involute.
/// @param force [N] of each mesh, in the transverse section
Warnings edge_warnings(const SetTeeth& teeth, double force);

}  // namespace orbearing::gearset
