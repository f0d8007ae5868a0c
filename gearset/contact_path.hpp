// Path of contact of a gear pair on its line of action.
#pragma once

#include "gearset/tooth_form.hpp"

namespace orbearing::gearset {

/// Part of the line of action that is in contact, measured from the point where it touches the base circle of
/// the second gear (the planet, in the meshes of a set) and positive towards that gear's tip.
struct ContactPath {
  double begin = 0.0;  // [m]
  double end = 0.0;    // [m]

  double length() const { return end - begin; }  // [m]
};

/// Path of contact of two external gears, ended by tips or by the feet of the involutes, whichever comes
/// first. Eq. (13) of gearset/README.md.
/// @param centre_distance [m] not below the sum of the base radii
/// @return length is negative where the gears do not reach each other
ContactPath external_contact_path(const ExternalTooth& first, const ExternalTooth& second,
                                  double centre_distance);

/// Path of contact of a ring and the external gear inside it. Eq. (14) of gearset/README.md.
/// @param centre_distance [m] not below the difference of the base radii
ContactPath internal_contact_path(const RingTooth& ring, const ExternalTooth& planet, double centre_distance);

/// Length of the path of contact in units of the base pitch [-].
double contact_ratio(const ContactPath& path, const ExternalTooth& tooth);

}  // namespace orbearing::gearset
