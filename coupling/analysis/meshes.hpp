// Meshes of gears: stiffness over the mesh period, contact ratio, phases, and comparison with the standard.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearset/mean_loads.hpp"
#include "gearset/mesh/iso6336.hpp"
#include "gearset/mesh/loaded/transmission_error.hpp"
#include "gearset/mesh/mesh_stiffness.hpp"
#include "gearset/rim/rim_influence.hpp"
#include "gearset/warning.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

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

/// Circles of a gear of either kind in one mesh.
template <class Tooth>
GearCircles circles_of(const char* gear, const Tooth& tooth, double working_pressure_angle) {
  return {.gear = gear,
          .tip = 2.0 * tooth.tip_radius,
          .reference = 2.0 * tooth.pitch_radius,
          .base = 2.0 * tooth.base_radius,
          .root = 2.0 * tooth.root_radius,
          .pitch = 2.0 * tooth.base_radius / std::cos(working_pressure_angle),
          .at_ring = {}};
}

/// Adds warnings as "key: text".
void add_texts(const gearset::Warnings& warnings, std::vector<std::string>& texts);

/// Warnings of the standard for a mesh outside of its range.
void warn_of_standard(const NamedMesh& mesh, std::vector<std::string>& texts);

}  // namespace orbearing::analysis
