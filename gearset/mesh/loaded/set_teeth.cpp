#include "gearset/mesh/loaded/set_teeth.hpp"

#include <algorithm>

#include "gearset/mesh/iso6336.hpp"
#include "gearset/mesh/loaded/transmission_error.hpp"
#include "gearset/message.hpp"

namespace orbearing::gearset {

SetTeeth set_teeth(const PlanetarySet& set, const PlanetaryMeshes& meshes) {
  SetTeeth teeth{tooth_pairs(meshes.sun_gears, sun_mesh_modifications(set.flanks, set.module)),
                 tooth_pairs(meshes.ring_gears, ring_mesh_modifications(set.flanks, set.module))};
  if (set.web.thickness)
    for (ToothPairs* pairs : {&teeth.sun, &teeth.ring})
      pairs->teeth = pairs->teeth.times(web_factor(set.web));
  return teeth;
}

Warnings edge_warnings(const SetTeeth& teeth, double force) {
  Warnings warnings;
  const auto consider = [&](const ToothPairs& pairs, const std::string& name) {
    const std::vector<double> curve = transmission_error(pairs.teeth, force).curve;
    const double own = *std::max_element(curve.begin(), curve.end()) - pairs.teeth.shared() * force;
    if (own <= pairs.sound) return;
    warnings.push_back(
        {"gearset.tooth_contact",
         "teeth of " + name + " and planet give way by up to " + decimal(1e6 * own, 1) + " um; from " +
             decimal(1e6 * pairs.sound, 1) +
             " um on a tip touches the fillet of the other gear's root, where the direction of the force is "
             "not that of the line of action; it is taken as if it were"});
  };
  consider(teeth.sun, "sun");
  consider(teeth.ring, "ring");
  return warnings;
}

}  // namespace orbearing::gearset
