// Meshes of a case: stiffness over the period, contact ratio, phases, and the standard's opinion beside.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/results/terminal_chart.hpp"
#include "coupling/study/drivetrain.hpp"
#include "gearset/mean_loads.hpp"
#include "gearset/mesh/iso6336.hpp"
#include "gearset/mesh/loaded/transmission_error.hpp"
#include "gearset/mesh/mesh_stiffness.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/rim/rim_influence.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// One mesh of a case.
struct NamedMesh {
  std::string name;                  // "sun-planet 1"
  std::string first;                 // "sun"
  std::string second;                // "planet"
  double phase = 0.0;                // [mesh period]  by which it lags behind the first mesh of the case
  gearset::MeshStiffness stiffness;  // of loaded teeth about the mean load
  gearset::Iso6336Stiffness standard;
  double face_width = 0.0;                            // [m]
  std::optional<gearset::TransmissionError> error{};  // of a set, under the mean load of its meshes
};

/// The parts at the pitch point are those of the first gear's tooth; `gears` holds them for both.
void describe(described::Record& row, const NamedMesh& mesh);

/// Axial forces of a set with helical teeth at the case's input.
struct AxialForces {
  double base_helix_angle = 0.0;  // [rad]
  gearset::MeanLoads loads;
  gearset::SunThrust held_by = gearset::SunThrust::housing;
  gearset::AxialReactions reactions;
};

/// Circles of one gear, transverse. Gears that mesh twice have a working pitch circle in each mesh.
struct GearCircles {
  std::string gear;               // "sun"
  double tip = 0.0;               // [m]  diameters
  double reference = 0.0;         // [m]
  double base = 0.0;              // [m]
  double root = 0.0;              // [m]
  double pitch = 0.0;             // [m]  working; of a planet in the sun mesh
  std::optional<double> at_ring;  // [m]  working, of a planet in the ring mesh
};

/// Of sun, planet and ring, and of the second gear of a stepped planet.
std::vector<GearCircles> gear_circles(const gearset::WorkingGeometry& geometry);
/// The same for `check`, each under `prefix` and its gear's name: "gearset.sun.tip_diameter".
std::vector<Derived> circle_quantities(const std::string& prefix, const std::vector<GearCircles>& gears);
void describe(described::Record& row, const GearCircles& gear);

struct MeshStudy {
  std::vector<NamedMesh> meshes;
  std::vector<GearCircles> gears;
  std::optional<AxialForces> axial;                              // of helical teeth
  std::shared_ptr<const gearset::rim::RimInfluence> planet_rim;  // where the case has it elastic
  std::vector<std::string> warnings;
};

/// Axial forces are positive along the axis on which the carrier turns counterclockwise; influence functions
/// of the rim are orders of waves from 0 on.
void describe(described::Record& record, const MeshStudy& study);

/// Of a case of the model gear-pair or planetary-drivetrain. Throws BadInput for another model.
MeshStudy mesh_study(const ResolvedCase& resolved);

/// Meshes of the set of a case of the model planetary-drivetrain, as its members turn at its drive.
gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& resolved);
/// The same where drivetrain and geometry of the case are at hand.
gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& resolved,
                                             const study::PlanetaryDrivetrain& drivetrain,
                                             const gearset::WorkingGeometry& geometry);

/// What follows from the inputs of a gear-pair, for `orbearing check`.
std::vector<Derived> pair_quantities(const ResolvedCase& resolved, const MeshStudy& study);

// Charts of the meshes of a case, for terminals.

/// A chart of each kind of mesh.
std::string mesh_charts(const MeshStudy& study, Glyphs glyphs);

}  // namespace orbearing::app
