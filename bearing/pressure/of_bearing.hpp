// The half-space contact of a bearing's roller with one of its races.
#pragma once

#include "bearing/geometry.hpp"
#include "bearing/pressure/contact.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::bearing::half_space {

/// Roller with corrected free ends on a race that goes on beyond them.
inline HalfSpaceContact contact_of(const Bearing& bearing, Race race) {
  return {.length = bearing.rollers().length,
          .equivalent_radius = equivalent_radius(geometry_of(bearing), race),
          .roller = bearing.material,
          .race = bearing.material};
}

/// Relief of both bodies together.
inline Relief relief_of(const profile::Profile& roller, const profile::Profile& race = profile::Straight{}) {
  return [roller, race](double x) { return profile::drop(roller, x) + profile::drop(race, x); };
}

}  // namespace orbearing::bearing::half_space
