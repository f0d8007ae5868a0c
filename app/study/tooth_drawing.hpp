// A pair of teeth in contact, as points to draw.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::app {

/// Sun and planet, ring and planet, each touching at its pitch point (at the nearest place of contact where
/// the teeth do not reach it). Lengths in mm from the pitch point, y along the line of centres towards the
/// second axis (sun mesh) or away from both (ring mesh); the tooth on the left pushes to the right.
///
///     centre_y, sense   a point at radius R, angle phi from the line of centres is (R sin phi, centre_y +
///     sense R cos phi) axis_deg          phi of the axis of symmetry of the touching tooth radius_mm,
///     half_angle_deg   its flank from root to tip
nlohmann::ordered_json tooth_pairs_json(const gearset::WorkingGeometry& geometry,
                                        const gearset::PlanetaryMeshes& meshes);

}  // namespace orbearing::app
