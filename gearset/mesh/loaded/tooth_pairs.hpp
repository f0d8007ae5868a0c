// Pairs of teeth as a mesh under load needs them, from the geometry of both gears.
#pragma once

#include "gearset/flank_modifications.hpp"
#include "gearset/mesh/loaded/loaded_teeth.hpp"
#include "gearset/mesh/mesh_stiffness.hpp"
#include "gearset/mesh/planetary_meshes.hpp"

namespace orbearing::gearset {

// Gap of the flanks of a pair of teeth before and after its path of contact, and their point of contact as
// deflection closes that gap.

/// Which end of the path of contact.
enum class PathEnd { begin, end };

/// The edge that ends the path there, and with which a gear touches the flank of the other just beyond: its
/// tip, or where undercut has cut its flank short.
struct EdgeAtEnd {
  bool of_first = false;  // of the first gear of the mesh
  double tangent = 0.0;   // [m]  tangent length of the edge on its own gear
};

EdgeAtEnd edge_at(const MeshingGears& gears, PathEnd end);

/// A pair of teeth at one position.
struct FlankGap {
  double gap = 0.0;     // [m]  along the line of action
  double first = 0.0;   // [m]  tangent lengths of the points that touch
  double second = 0.0;  // [m]
  bool on_involute =
      true;  // false: an edge on the other gear's trochoid, whose normal is not the line of action
};

/// @param position [m] on the line of action, where the flanks would touch if they went on: in the path of
/// contact without a gap. Eqs. (1) to (3) of gearset/mesh/loaded/README.md.
FlankGap flank_gap(const MeshingGears& gears, double position);

/// Position at which, beyond an end of the path, contact changes from the foot of an undercut flank to the
/// tip; the end itself if the tip ends the path. The gap has a corner there. [m]
double tip_takes_over(const MeshingGears& gears, PathEnd end);

/// Tip relief of one gear.
struct TipRelief {
  double amount = 0.0;  // [m]  at the tip
  double length = 0.0;  // [m]  along the line of action
  ReliefForm form = ReliefForm::linear;
};

/// Deviations of the flanks of one mesh from involutes.
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

/// @throws std::domain_error where the bodies turn by more than the teeth with their foundations deflect
ToothPairs tooth_pairs(const MeshingGears& gears, const MeshModifications& modifications = {},
                       int slices = face_slices);

// Teeth under load of both meshes of a planetary set.

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
