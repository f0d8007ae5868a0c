// How far the flanks of a pair of teeth are apart before and after its path of contact, and where they
// touch as deflection closes that gap.
#pragma once

#include "gearset/mesh/mesh_stiffness.hpp"

namespace orbearing::gearset {

/// Which end of the path of contact.
enum class PathEnd { begin, end };

/// The edge that ends the path there, and with which a gear touches the flank of the other just beyond: its
/// tip, or where undercut has cut its flank short.
struct EdgeAtEnd {
  bool of_first = false;  // of the first gear of the mesh
  double tangent = 0.0;   // [m]  tangent length of the edge on its own gear
};

EdgeAtEnd edge_at(const MeshingGears& gears, PathEnd end);

/// A pair of teeth at one place.
struct FlankGap {
  double gap = 0.0;     // [m]  along the line of action
  double first = 0.0;   // [m]  tangent lengths of the points that touch
  double second = 0.0;  // [m]
  bool on_involute =
      true;  // false: an edge on the other gear's trochoid, whose normal is not the line of action
};

/// @param place [m] on the line of action, where the flanks would touch if they went on: in the path of
/// contact without a gap. Eqs. (1) to (3) of gearset/mesh/loaded/README.md.
FlankGap flank_gap(const MeshingGears& gears, double position);

/// Where the tip takes over from the foot of an undercut flank beyond an end of the path; the end itself
/// where the tip ends the path. The gap has a corner there. [m]
double tip_takes_over(const MeshingGears& gears, PathEnd end);

}  // namespace orbearing::gearset
