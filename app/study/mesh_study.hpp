// Meshes of a case: stiffness over the period, contact ratio, phases, and the standard's opinion beside.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/set_meshes.hpp"

namespace orbearing::app {

using analysis::MeshStudy;

/// Study of a case of the model gear-pair or planetary-drivetrain. Throws BadInput for another model.
MeshStudy mesh_study(const ResolvedCase& resolved);

/// The same with all that the command warns of: inputs without effect, too, which it refuses where they ought
/// to count, and implausible values.
MeshStudy mesh_study_with_warnings(const ResolvedCase& resolved);

/// Meshes of the set of a case of the model planetary-drivetrain, as its members turn at its drive.
gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
