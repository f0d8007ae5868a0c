// Values of a drawing that follow from others: stated as a check, without effect on results.
#pragma once

#include <optional>
#include <string>

#include "gearset/parameters.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

/// Values that teeth, module and profile shifts give as well.
struct StatedGeometry {
  std::optional<double> centre_distance;  // [m]       working
  std::optional<double> planet_shift;     // [module]
};
template <class Visitor>
void describe(Visitor& visit, StatedGeometry& m) {
  using namespace described;
  members(visit, m,
          internal(m.centre_distance, "gearset.centre_distance", "", {.dimension = dimension::length}),
          internal(m.planet_shift, "gearset.profile_shift.planet"));
}

/// Stated values that do not follow from the set, each with the value that does. Text: what is required.
Warnings geometry_problems(const PlanetarySet& set, const StatedGeometry& stated);

/// Warns of a negative profile shift of the ring: it is legal, but sources by DIN 3960 print it for a
/// positive shift. Gives both readings where the other could be assembled too and no stated value excludes
/// it.
Warnings ring_sign_warnings(const PlanetarySet& set, const StatedGeometry& stated);

}  // namespace orbearing::gearset
