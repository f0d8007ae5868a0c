// Pairs and sets that several tests of the mesh share.
#pragma once

#include <array>

#include "gearset/gear_pair.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset {

/// m = 2 mm, 20 mm wide, bore 35 mm (10 mm where a gear has fewer than 25 teeth), standard rack.
inline GearPair example_pair(int first, int second, double first_shift = 0.0, double second_shift = 0.0) {
  const double bore = std::min(first, second) < 25 ? 10e-3 : 35e-3;
  return {{first, second}, {first_shift, second_shift}, 2e-3, 20e-3, bore, {}};
}

inline MeshingGears meshing(const GearPair& pair, bool first_drives = true,
                            const mechanics::Material& material = {}) {
  const PairGeometry geometry = pair_geometry(pair);
  const auto gear = [&](std::size_t i) {
    return make_mesh_gear(geometry.gears.at(i), 0.5 * pair.bore, pair.face_width, material);
  };
  return meshing_gears(gear(0), gear(1), geometry.centre_distance, first_drives);
}

inline PlanetaryMeshes meshes_of(PlanetarySet set, const MeshMotion& motion = {}) {
  if (set.planet_bore == 0.0) set.planet_bore = 42e-3;  // the source prints no bearing for one of its sets
  return planetary_meshes(set, working_geometry(set), {}, {}, motion);
}

}  // namespace orbearing::gearset
