// Deflection of a tooth caused by the deflection of the gear body under it.
#pragma once

#include "gearset/tooth_form.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset {

// Line of the mesh force on a tooth, by the position of contact on the line of action.

/// Line of the force on one tooth, in the frame of the tooth: axis of symmetry and gear axis.
struct ToothLoad {
  double contact_radius = 0.0;  // [m]    of the point of contact
  double force_angle = 0.0;     // [rad]  of the force to the line across the tooth; grows towards the tip
  double axis_radius =
      0.0;  // [m]    where the force's line cuts the tooth's axis of symmetry; of helical teeth
            //        in the section normal to them
};

/// Load at a point of contact. Eqs. (1), (2) and (18) of gearset/mesh/README.md.
/// @param tangent_length [m] from the tangent point on the gear's base circle to the point of contact
ToothLoad tooth_load(const ExternalTooth& tooth, double tangent_length);
ToothLoad tooth_load(const RingTooth& tooth, double tangent_length);

/// The body under a tooth.
struct FoundationBody {
  double root_radius = 0.0;  // [m]    radius of the circle at the root of the tooth
  double half_angle = 0.0;   // [rad]  half the angle that the tooth spans there
  double body_radius = 0.0;  // [m]    where the body is held: the bore; of a ring, the outside
  double helix_angle = 0.0;  // [rad]  of its teeth
};

FoundationBody foundation_body(const ExternalTooth& tooth, double bore_radius);
FoundationBody foundation_body(const RingTooth& tooth, double outside_radius);

/// L, M, P, Q of Eq. (6) of gearset/mesh/README.md: by moment, by moment and shear, by shear, by compression.
struct FoundationCoefficients {
  double moment = 0.0;
  double cross = 0.0;
  double shear = 0.0;
  double compression = 0.0;  // as a share of `shear`
};

/// The published polynomials [Sainsot2004], for external gears on a rigid shaft.
/// @param half_angle [rad] theta_f
/// @param ratio      root radius / bore radius
FoundationCoefficients sainsot_coefficients(double half_angle, double ratio);

/// Whether the polynomials are used where their authors fitted them: ratio 1.4 to 7, angle 0.01 to 0.12 rad.
bool in_sainsot_range(const FoundationBody& body);

/// Whether the polynomials still give a value of the right size: to a ratio of 20 and down to 0.005 rad; the
/// powers of h and 1/theta run away beyond, to negative stiffness too.
bool sainsot_is_usable(const FoundationBody& body);

/// Deflection along the force in the transverse section per unit of that force. Eqs. (6) and (15) of
/// gearset/mesh/README.md.
/// @return [m/N]
double foundation_compliance(const FoundationCoefficients& coefficients, const FoundationBody& body,
                             const ToothLoad& load, double face_width, const mechanics::Material& material);

}  // namespace orbearing::gearset
