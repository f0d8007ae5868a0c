// Parameters that make the stiffness of meshes.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace orbearing::app {

/// Whether the stiffness of the meshes follows from a parameter, beside those that make the planets
/// themselves.
inline bool makes_meshes(std::string_view path) {
  constexpr std::string_view making[] = {"gearset.addendum_of.sun",
                                         "gearset.addendum_of.ring",
                                         "gearset.clearance_of.sun",
                                         "gearset.clearance_of.ring",
                                         "gearset.web.thickness",
                                         "gearset.web.rim",
                                         "gearset.tooth_contact",
                                         "gearset.tip_relief.sun",
                                         "gearset.tip_relief.planet",
                                         "gearset.tip_relief.ring",
                                         "gearset.tip_relief.length",
                                         "gearset.tip_relief.form",
                                         "gearset.lead_crown.sun",
                                         "gearset.lead_crown.planet",
                                         "gearset.lead_crown.ring",
                                         "gearset.lead_slope.sun",
                                         "gearset.lead_slope.ring",
                                         "gearset.dynamics.mesh_stiffness.sun",
                                         "gearset.dynamics.mesh_stiffness.ring"};
  return std::find(std::begin(making), std::end(making), path) != std::end(making);
}

}  // namespace orbearing::app
