// Meshes of a case: stiffness over the period, contact ratio, phases, and the standard's opinion beside.
#pragma once

#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "coupling/analysis/meshes.hpp"
#include "coupling/study/drivetrain.hpp"
#include "gearset/mesh/planetary_meshes.hpp"

namespace orbearing::app {

using analysis::AxialForces;
using analysis::GearCircles;
using analysis::MeshStudy;
using analysis::NamedMesh;

/// Circles of sun, planet and ring, and of the second gear of a stepped planet.
std::vector<GearCircles> gear_circles(const gearset::WorkingGeometry& geometry);
/// The same for `check`, each under `prefix` and its gear's name: "gearset.sun.tip_diameter".
std::vector<Derived> circle_quantities(const std::string& prefix, const std::vector<GearCircles>& gears);

/// Study of a case of the model gear-pair or planetary-drivetrain. Throws BadInput for another model.
MeshStudy mesh_study(const ResolvedCase& resolved);

/// Meshes of the set of a case of the model planetary-drivetrain, as its members turn at its drive.
gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& resolved);
/// The same where drivetrain and geometry of the case are at hand.
gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& resolved,
                                             const study::PlanetaryDrivetrain& drivetrain,
                                             const gearset::WorkingGeometry& geometry);

}  // namespace orbearing::app
