// How the force in a mesh lies on a tooth, by the place of contact on the line of action.
#pragma once

#include "gearset/tooth_form.hpp"

namespace orbearing::gearset {

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

}  // namespace orbearing::gearset
