// One gear of a mesh: how its tooth and body give way under the force at a point of contact.
#pragma once

#include <variant>

#include "gearset/mesh/foundation.hpp"
#include "gearset/mesh/tooth_beam.hpp"

namespace orbearing::gearset {

/// Tooth and body of one gear, prepared once.
struct MeshGear {
  std::variant<ExternalTooth, RingTooth> tooth;
  FoundationBody body;
  FoundationCoefficients foundation;
  bool exact = false;       // foundation by the elastic ring whatever the polynomials' range
  double face_width = 0.0;  // [m]
  mechanics::Material material;
};

/// Which law of the foundation an external gear has.
enum class Foundation {
  polynomials,   // of [Sainsot2004], the elastic ring where these are of no use
  elastic_ring,  // exact: beside a rim that bends as a whole
};

/// An external gear on a rigid shaft.
/// @param bore_radius [m] at most the root radius
/// @throws std::domain_error if the bore is larger than the root circle or none
MeshGear make_mesh_gear(const ExternalTooth& tooth, double bore_radius, double face_width,
                        const mechanics::Material& material, Foundation law = Foundation::polynomials);

/// A ring gear held rigidly at its outside; foundation by the elastic ring, since the polynomials are for
/// external gears.
/// @param outside_radius [m] more than the root radius
MeshGear make_mesh_gear(const RingTooth& tooth, double outside_radius, double face_width,
                        const mechanics::Material& material);

/// Deflection of one gear's tooth along the force per unit of force, by its causes.
struct GearCompliance {
  BeamCompliance tooth;
  double foundation = 0.0;  // [m/N]

  double sum() const { return tooth.sum() + foundation; }  // [m/N]
};

/// @param tangent_length [m] from the tangent point on the gear's base circle to the point of contact
GearCompliance gear_compliance(const MeshGear& gear, double tangent_length);

double base_radius(const MeshGear& gear);  // [m]

}  // namespace orbearing::gearset
