// Pairs of teeth as a mesh under load needs them, from the geometry of both gears.
#pragma once

#include "gearset/flank_modifications.hpp"
#include "gearset/mesh/loaded/flank_gap.hpp"
#include "gearset/mesh/loaded/loaded_teeth.hpp"

namespace orbearing::gearset {

/// Tip relief of one gear.
struct TipRelief {
  double amount = 0.0;  // [m]  at the tip
  double length = 0.0;  // [m]  along the line of action
  ReliefForm form = ReliefForm::linear;
};

/// What flanks of one mesh depart from involutes by.
struct MeshModifications {
  TipRelief first;
  TipRelief second;
  double crown = 0.0;  // [m]  of both gears together, at both ends of the face
  double slope = 0.0;  // [m]  from one end of the face to the other
};

MeshModifications sun_mesh_modifications(const FlankModifications& set, double module);
MeshModifications ring_mesh_modifications(const FlankModifications& set, double module);

/// By which a gear's body turns under the sum of the forces on its teeth, as displacement along the line of
/// action per force: shear of the ring between roots and where it is held. Eq. (5) of
/// gearset/mesh/loaded/README.md.
double body_torsion(const MeshGear& gear);  // [m/N]

/// Material that relief has taken off at a point of a flank. [m]
double relief_at(const MeshGear& gear, const TipRelief& relief, double tangent);

/// A mesh under load.
struct ToothPairs {
  LoadedTeeth teeth;
  double sound = 0.0;  // [m]  own deflection of the teeth beyond which an edge touches where its mate has no
                       //      involute
};

inline constexpr int face_slices = 32;  // of a face whose parts touch at unlike times

/// @throws std::domain_error where the bodies turn by more than the teeth with their foundations give way
ToothPairs tooth_pairs(const MeshingGears& gears, const MeshModifications& modifications = {},
                       int slices = face_slices);

}  // namespace orbearing::gearset
