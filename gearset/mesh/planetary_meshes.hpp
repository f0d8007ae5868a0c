// All meshes of a planetary set: stiffness over the mesh period, and when each begins.
#pragma once

#include <optional>
#include <vector>

#include "gearset/mesh/mesh_stiffness.hpp"
#include "gearset/parameters.hpp"
#include "gearset/warning.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

// When the meshes of a planetary set begin, one against another.

/// Directions of power and rotation of the set, viewed from its carrier.
struct MeshMotion {
  bool sun_drives = true;         // power flows from the sun to the planets, seen from the carrier
  bool sun_anticlockwise = true;  // the sun turns anticlockwise relative to the carrier
};

/// @param sun_torque         [N m]    external, on the sun
/// @param sun_speed_relative [rad/s]  to the carrier, anticlockwise
MeshMotion mesh_motion(double sun_torque, double sun_speed_relative);

/// The part of `periods` beyond whole ones, in [0, 1); a whole number but for round-off gives 0.
double whole_periods_off(double periods);

/// Lag of the sun mesh of a planet behind that of a planet at angle zero, in mesh periods; the ring meshes
/// lag alike, by the condition of assembly. Eq. (11) of gearset/mesh/README.md [ParkerLin2004].
/// @param planet_angle [rad] anticlockwise
/// @return in [0, 1)
double sun_mesh_lag(int sun_teeth, double planet_angle, const MeshMotion& motion);
double ring_mesh_lag(int ring_teeth, double planet_angle, const MeshMotion& motion);

/// Lag of the ring mesh of a planet behind its sun mesh, contact of a pair of teeth beginning at fraction
/// zero in both. Eq. (12) of gearset/mesh/README.md.
/// @param sun_mesh, ring_mesh of the same planet, which is `second` in both
/// @return [mesh period] in [0, 1)
double ring_to_sun_lag(const MeshingGears& sun_mesh, const MeshingGears& ring_mesh, double sun_working_angle,
                       double ring_working_angle);

/// Bodies of sun and ring; the planet's is given by its bore.
struct BodyRatios {
  double sun_bore = 0.5;       // [-]  bore / root diameter
  double ring_outside = 1.15;  // [-]  outside / root diameter
};
template <class Visitor>
void describe(Visitor& visit, BodyRatios& m) {
  using namespace described;
  members(visit, m, internal(m.sun_bore, "gearset.sun_bore_ratio"),
          internal(m.ring_outside, "gearset.ring_outside_ratio"));
}

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
/// @param set whose planets are at positions where it can be assembled; of stepped ones the lags of the ring
/// meshes have no meaning, since how far their gears are turned against each other is not known
/// @throws std::domain_error if a gear has no body under its teeth
PlanetaryMeshes planetary_meshes(const PlanetarySet& set, const WorkingGeometry& geometry,
                                 const BodyRatios& bodies, const mechanics::Material& material,
                                 const MeshMotion& motion, std::optional<double> held_race = {});

/// Warning if a gear's body lies outside the range of the polynomials of [Sainsot2004], with the result of
/// the elastic ring instead; none for a ring gear.
/// @param tangent_length [m] on the gear, where the two are compared
/// @param position of the body in the case
Warnings foundation_warnings(const MeshGear& gear, double tangent_length, const std::string& name,
                             const std::string& position);
Warnings foundation_warnings(const PlanetaryMeshes& meshes);

}  // namespace orbearing::gearset
