// All meshes of a planetary set: stiffness over the mesh period, and when each begins.
#pragma once

#include <optional>
#include <vector>

#include "gearset/mesh/mesh_phase.hpp"
#include "gearset/parameters.hpp"
#include "gearset/warning.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

/// Bodies of sun and ring; the planet's is given by its bore.
struct BodyRatios {
  double sun_bore = 0.5;       // [-]  bore / root diameter
  double ring_outside = 1.15;  // [-]  outside / root diameter
};

/// The stiffness of sun mesh n at time t is sun.curve.value(t / period - sun_lag[n]), of ring mesh n
/// ring.curve.value(t / period - ring_lag[n]); the planets are numbered anticlockwise.
struct PlanetaryMeshes {
  MeshingGears sun_gears;
  MeshingGears ring_gears;
  MeshStiffness sun;
  MeshStiffness ring;
  std::vector<double> sun_lag;   // [mesh period]  (planets)  behind the sun mesh of the first planet
  std::vector<double> ring_lag;  // [mesh period]  (planets)  behind the sun mesh of the first planet
};

/// @param held_race [m] radius of the race at which the planet is held, whose rim bends as a whole besides
/// (gearset/rim): foundation by the elastic ring. None: held at its bore, as published models have it
/// @param set whose planets stand where it can be assembled
/// @throws std::domain_error if a gear has no body under its teeth
PlanetaryMeshes planetary_meshes(const PlanetarySet& set, const WorkingGeometry& geometry,
                                 const BodyRatios& bodies, const mechanics::Material& material,
                                 const MeshMotion& motion, std::optional<double> held_race = {});

/// Whether a gear's body lies outside the range of the polynomials of [Sainsot2004], and what the elastic
/// ring gives in their place; none for a ring gear.
/// @param tangent_length [m] on the gear, where the two are compared
/// @param place of the case that states the body
Warnings foundation_warnings(const MeshGear& gear, double tangent_length, const std::string& name,
                             const std::string& position);
Warnings foundation_warnings(const PlanetaryMeshes& meshes);

}  // namespace orbearing::gearset
