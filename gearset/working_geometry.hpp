// The set as assembled: one centre distance for both meshes, and all that follows from it.
#pragma once

#include <optional>

#include "gearset/contact_path.hpp"
#include "gearset/parameters.hpp"
#include "gearset/tooth_form.hpp"

namespace orbearing::gearset {

/// One mesh of a planet at the working centre distance.
struct MeshGeometry {
  double working_pressure_angle = 0.0;  // [rad]  transverse
  ContactPath path;                     // from the tangent point on the planet's base circle
  double contact_ratio = 0.0;           // [-]    transverse
};

/// A ring and the external gear inside it, at their working centre distance.
struct InternalMesh {
  RingTooth ring;
  ExternalTooth inside;
  double centre_distance = 0.0;  // [m]
  MeshGeometry mesh;             // from the tangent point on the base circle of the gear inside
};

/// Transverse working pressure angle without backlash, from the sums of teeth and profile shifts of external
/// gears, or from those of a ring less those of the gear inside it. Eqs. (2) and (3) of gearset/README.md.
/// @param gear    either of them, for the rack
/// @param shifts  [module]
/// @return [rad]
/// @throws std::domain_error if there is no such angle of at most 45 deg
double angle_without_backlash(const ExternalTooth& gear, double teeth, double shifts);

/// A ring and the gear inside it at the distance that leaves no backlash.
/// @throws std::domain_error as above, or if the gear inside has as many teeth
InternalMesh mesh_without_backlash(const RingTooth& ring, const ExternalTooth& inside);

/// Derived once from the parameters of the set.
struct WorkingGeometry {
  double centre_distance = 0.0;  // [m]       sun axis to planet axis, working
  double planet_shift = 0.0;     // [module]
  ExternalTooth sun;
  ExternalTooth planet;
  RingTooth ring;
  MeshGeometry sun_mesh;
  MeshGeometry ring_mesh;
  double base_helix_angle = 0.0;        // [rad]  of both meshes; positive: the sun's teeth are right-handed
  double overlap_ratio = 0.0;           // [-]    of both meshes
  std::optional<ExternalTooth> second;  // of a stepped planet, meshes with the ring

  /// The planet's gear in the ring mesh.
  const ExternalTooth& at_ring() const { return second ? *second : planet; }
};

/// The ring mesh of a set.
inline InternalMesh ring_mesh_of(const WorkingGeometry& geometry) {
  return {geometry.ring, geometry.at_ring(), geometry.centre_distance, geometry.ring_mesh};
}

/// Working radius of the planet in one of its meshes: where the force of the mean load acts. [m]
double planet_working_radius(const WorkingGeometry& geometry, const MeshGeometry& mesh);

/// Finds the centre distance, and with it the planet's shift, at which the planet meshes without backlash
/// with both sun and ring. Eqs. (2) to (5) of gearset/README.md, in the transverse section of helical teeth.
/// With stepped planets the ring mesh determines the distance, and the first gear's shift follows from it.
/// @throws std::domain_error if no centre distance serves both meshes, or a tooth cannot be formed
WorkingGeometry working_geometry(const PlanetarySet& set);

}  // namespace orbearing::gearset
