// Stiffness of a mesh over its period, from the geometry of the teeth.
#pragma once

#include <array>

#include "gearset/contact_path.hpp"
#include "gearset/mesh/mesh_gear.hpp"
#include "gearset/mesh/periodic_curve.hpp"

namespace orbearing::gearset {

/// Two gears at their working centre distance. Places on the line of action are tangent lengths of the
/// second gear, as in ContactPath.
struct MeshingGears {
  MeshGear first;   // external gear or ring
  MeshGear second;  // external gear; the planet, in the meshes of a set
  ContactPath path;
  double line_length = 0.0;  // [m]  between the tangent points on both base circles
  double base_pitch = 0.0;   // [m]
  double face_width = 0.0;   // [m]  of contact
  bool first_drives = true;  // a pair of teeth comes into contact at the tip of the driven gear
  double base_helix_angle = 0.0;  // [rad]  without its hand
  double overlap_ratio = 0.0;     // [-]
};

/// @param centre_distance [m]
MeshingGears meshing_gears(const MeshGear& first, const MeshGear& second, double centre_distance,
                           bool first_drives);

/// Compliance of one pair of teeth in contact, in the transverse section along the line of action, [m/N]; of
/// helical teeth as if the whole face touched at that position.
struct PairCompliance {
  double hertz = 0.0;
  GearCompliance first;
  GearCompliance second;

  double sum() const { return hertz + first.sum() + second.sum(); }
};

/// Compliance of the line contact of two teeth: constant. Eq. (7) of gearset/mesh/README.md [YangLin1987].
double hertz_compliance(double face_width, const mechanics::Material& material);

/// @param position [m] of contact on the line of action
PairCompliance pair_compliance(const MeshingGears& gears, double position);

/// Position at which contact of a pair begins and direction in which it moves. [m] and +1 or -1
double contact_begin(const MeshingGears& gears);
double contact_direction(const MeshingGears& gears);

/// Pitch point, the intersection of the line of action with the line of centres; the nearest end of the path
/// of contact if shifted teeth do not reach it. [m]
double pitch_point(const MeshingGears& gears);

/// Sum over the pairs of teeth in contact, of a face that is all as its middle. Eq. (8) of
/// gearset/mesh/README.md.
/// @param fraction of the mesh period since a pair came into contact, in [0, 1)
/// @return [N/m]
double mesh_stiffness_at(const MeshingGears& gears, double fraction);

/// Fractions of the period at which a pair comes into contact (0) and one leaves it in the middle of the
/// face: the stiffness there jumps.
std::vector<double> contact_changes(const MeshingGears& gears);

/// Stiffness of a mesh, tabulated.
struct MeshStiffness {
  double contact_ratio = 0.0;  // [-]    transverse
  PeriodicCurve curve;         // [N/m]  along the line of action in the transverse section, over the fraction
                        //        of the period since a pair came into contact in the middle of the face
  PairCompliance at_pitch_point;  // of the one pair of teeth that touches there
  double overlap_ratio = 0.0;     // [-]
};

inline constexpr int mesh_samples = 96;  // a period; the error of the table is below 1e-7 of the stiffness

/// The stiffness of a mesh from that of one transverse section: slices across the face are ahead of each
/// other by up to the overlap ratio, and their sum is an integral over that part of the period, taken
/// exactly. Eq. (13) of gearset/mesh/README.md.
/// @param section [N/m] of a face that is all as its middle
PeriodicCurve across_face(const PeriodicCurve& section, double overlap_ratio, int samples = mesh_samples);

MeshStiffness mesh_stiffness(const MeshingGears& gears, int samples = mesh_samples);

}  // namespace orbearing::gearset
