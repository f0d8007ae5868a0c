// A tooth as a short beam of changing section: strain energy of bending, shear and compression.
#pragma once

#include <functional>
#include <vector>

#include "gearset/mesh/tooth_load.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset {

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
/// axis at `axis_place`. Eqs. (3) to (5) of gearset/mesh/README.md [YangLin1987].
/// @param pieces     from the root to the section at which the force enters
/// @param force_angle [rad]
/// @param axis_place  [m] counted as BeamSlice::place
/// @param width       [m]
BeamCompliance beam_compliance(const std::vector<BeamPiece>& pieces, double force_angle, double axis_position,
                               double width, const mechanics::Material& material);

/// Compliance of a tooth between its root circle and the point of contact; places are distances from the
/// gear's axis, so root fillets and undercuts count with their true form.
/// @param face_width [m]
BeamCompliance tooth_compliance(const ExternalTooth& tooth, const ToothLoad& load, double face_width,
                                const mechanics::Material& material);
BeamCompliance tooth_compliance(const RingTooth& tooth, const ToothLoad& load, double face_width,
                                const mechanics::Material& material);

}  // namespace orbearing::gearset
