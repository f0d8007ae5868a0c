#include "gearset/mesh/planetary_meshes.hpp"

#include <cmath>

#include "gearset/mesh/elastic_ring.hpp"
#include "gearset/mesh/iso6336.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/stepped_planet.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

using constants::pi;

}  // namespace

MeshMotion mesh_motion(double sun_torque, double sun_speed_relative) {
  return {.sun_drives = sun_torque * sun_speed_relative > 0.0, .sun_anticlockwise = sun_speed_relative > 0.0};
}

double whole_periods_off(double periods) {
  constexpr double round_off = 1e-12;
  const double fraction = periods - std::floor(periods);
  return fraction > 1.0 - round_off || fraction < round_off ? 0.0 : fraction;
}

double sun_mesh_lag(int sun_teeth, double planet_angle, const MeshMotion& motion) {
  const double teeth = sun_teeth * planet_angle / (2.0 * pi);
  return whole_periods_off(motion.sun_anticlockwise ? teeth : -teeth);
}

double ring_mesh_lag(int ring_teeth, double planet_angle, const MeshMotion& motion) {
  const double teeth = ring_teeth * planet_angle / (2.0 * pi);
  return whole_periods_off(motion.sun_anticlockwise ? -teeth : teeth);
}

double ring_to_sun_lag(const MeshingGears& sun_mesh, const MeshingGears& ring_mesh, double sun_working_angle,
                       double ring_working_angle) {
  const ExternalTooth& planet = std::get<ExternalTooth>(sun_mesh.second.tooth);
  // From the tooth that touches at the sun's tangent point to one that touches at the ring's, opposite
  // flanks.
  const double between = planet.teeth / (2.0 * pi) *
                         (2.0 * base_half_angle(planet) + sun_working_angle + ring_working_angle - pi);
  const double begins = (contact_begin(sun_mesh) + contact_begin(ring_mesh)) / sun_mesh.base_pitch;
  const double lead = between - begins;
  return whole_periods_off(sun_mesh.first_drives ? -lead : lead);
}

PlanetaryMeshes planetary_meshes(const PlanetarySet& set, const WorkingGeometry& geometry,
                                 const BodyRatios& bodies, const mechanics::Material& material,
                                 const MeshMotion& motion, std::optional<double> held_race) {
  const double width = set.face_width;
  const double a = geometry.centre_distance;
  const MeshGear planet =
      make_mesh_gear(geometry.planet, held_race.value_or(0.5 * set.planet_bore), width, material,
                     held_race ? Foundation::elastic_ring : Foundation::polynomials);
  const MeshGear sun =
      make_mesh_gear(geometry.sun, bodies.sun_bore * geometry.sun.root_radius, width, material);
  const MeshGear ring = make_mesh_gear(geometry.ring, bodies.ring_outside * geometry.ring.root_radius,
                                       ring_face(set), material);
  const MeshGear at_ring =
      geometry.second ? make_mesh_gear(*geometry.second, 0.5 * set.planet_bore, ring_face(set), material)
                      : planet;
  PlanetaryMeshes meshes{.sun_gears = meshing_gears(sun, planet, a, motion.sun_drives),
                         .ring_gears = meshing_gears(ring, at_ring, a, !motion.sun_drives)};
  meshes.sun = mesh_stiffness(meshes.sun_gears);
  meshes.ring = mesh_stiffness(meshes.ring_gears);
  if (set.web.thickness)
    for (MeshStiffness* mesh : {&meshes.sun, &meshes.ring})
      mesh->curve = mesh->curve.times(web_factor(set.web));
  const double to_ring =
      ring_to_sun_lag(meshes.sun_gears, meshes.ring_gears, geometry.sun_mesh.working_pressure_angle,
                      geometry.ring_mesh.working_pressure_angle);
  for (const double angle : angles_of_planets(set)) {
    meshes.sun_lag.push_back(sun_mesh_lag(set.sun_teeth, angle, motion));
    meshes.ring_lag.push_back(whole_periods_off(to_ring + ring_mesh_lag(set.ring_teeth, angle, motion)));
  }
  return meshes;
}

namespace {

// Difference of an elastic ring to the polynomials, for the end of a message.
std::string by_elastic_ring(const MeshGear& gear, const ToothLoad& load) {
  constexpr double thinnest = 1.01;  // root over bore diameter
  if (!sainsot_is_usable(gear.body)) return ". An elastic ring with a rigid bore is used instead";
  if (gear.body.root_radius < thinnest * gear.body.body_radius)
    return ". A body this thin, held at its bore, does not deflect";
  const auto compliance = [&](const FoundationCoefficients& coefficients) {
    return foundation_compliance(coefficients, gear.body, load, gear.face_width, gear.material);
  };
  const double exact = compliance(elastic_ring_coefficients(gear.body, gear.material.poisson_ratio));
  const double more = 100.0 * (compliance(gear.foundation) / exact - 1.0);  // [%]
  return ". An elastic ring with a rigid bore is " + decimal(std::abs(more), 0) +
         (more > 0.0 ? " % stiffer" : " % softer");
}

}  // namespace

Warnings foundation_warnings(const MeshGear& gear, double tangent_length, const std::string& name,
                             const std::string& position) {
  const auto* tooth = std::get_if<ExternalTooth>(&gear.tooth);
  if (tooth == nullptr || gear.exact || in_sainsot_range(gear.body)) return {};
  return {{position, "the foundation of the " + name + " has a root over bore diameter of " +
                         decimal(gear.body.root_radius / gear.body.body_radius, 3) +
                         " and a half tooth angle at the root of " + decimal(gear.body.half_angle, 3) +
                         " rad. Sainsot's formula covers 1.4 to 7 and 0.01 to 0.12 rad" +
                         by_elastic_ring(gear, tooth_load(*tooth, tangent_length))}};
}

Warnings foundation_warnings(const PlanetaryMeshes& meshes) {
  const double position = pitch_point(meshes.sun_gears);
  Warnings all = foundation_warnings(meshes.sun_gears.first, meshes.sun_gears.line_length - position, "sun",
                                     "gearset.sun_bore_ratio");
  for (Warning& warning :
       foundation_warnings(meshes.sun_gears.second, position, "planet", "bearing.outside_diameter"))
    all.push_back(std::move(warning));
  return all;
}

}  // namespace orbearing::gearset
