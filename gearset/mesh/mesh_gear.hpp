// One gear of a mesh: compliance of its tooth and body under the force at a point of contact.
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "gearset/mesh/foundation.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset {

// A tooth as a short beam of changing section: strain energy of bending, shear and compression.

/// Section of the tooth at one value of the parameter that its outline is described by.
struct BeamSlice {
  double position = 0.0;        // [m]                    along the tooth's axis
  double half_thickness = 0.0;  // [m]
  double measure = 0.0;         // [m per parameter unit] length of beam per step of the parameter
};

/// A smooth part of the outline, between two values of its own parameter.
struct BeamPiece {
  double begin = 0.0;
  double end = 0.0;
  std::function<BeamSlice(double parameter)> slice;
};

/// Deflection along the force per unit of force, by what stores the energy.
struct BeamCompliance {
  double bending = 0.0;  // [m/N]
  double shear = 0.0;    // [m/N]
  double axial = 0.0;    // [m/N]

  double sum() const { return bending + shear + axial; }  // [m/N]
};

/// Compliance of a clamped beam under a force at `force_angle` to the line across, whose line cuts the beam's
/// axis at `axis_position`. Eqs. (3) to (5) of gearset/mesh/README.md [YangLin1987].
/// @param pieces     from the root to the section at which the force enters
/// @param force_angle [rad]
/// @param axis_position [m] counted as BeamSlice::position
/// @param width       [m]
BeamCompliance beam_compliance(const std::vector<BeamPiece>& pieces, double force_angle, double axis_position,
                               double width, const mechanics::Material& material);

/// Compliance of a tooth between its root circle and the point of contact; positions are distances from the
/// gear's axis, so root fillets and undercuts are included with their true form.
/// @param face_width [m]
BeamCompliance tooth_compliance(const ExternalTooth& tooth, const ToothLoad& load, double face_width,
                                const mechanics::Material& material);
BeamCompliance tooth_compliance(const RingTooth& tooth, const ToothLoad& load, double face_width,
                                const mechanics::Material& material);

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
  elastic_ring,  // exact: in addition to a rim that bends as a whole
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
