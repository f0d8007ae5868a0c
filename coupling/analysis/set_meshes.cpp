#include "coupling/analysis/set_meshes.hpp"

#include "gearset/checks.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"

namespace orbearing::analysis {

namespace {

void load_teeth(const gearset::LoadedTeeth& teeth, double force, NamedMesh& mesh) {
  mesh.stiffness.curve = gearset::tangent_spring(teeth, force).stiffness;
  mesh.error = gearset::transmission_error(teeth, force);
}

}  // namespace

MeshStudy meshes_of_set(const PlanetaryDrivetrain& drivetrain, const SetGears& gears,
                        const gearset::StatedGeometry& stated) {
  const gearset::PlanetarySet& set = drivetrain.set;
  const gearset::WorkingGeometry geometry = gearset::working_geometry(set);
  const gearset::PlanetaryMeshes meshes = set_meshes(drivetrain, geometry, gears);
  const mechanics::Material material = gears.material.material();
  const double shift = geometry.planet_shift;
  NamedMesh sun{.first = "sun", .second = "planet", .stiffness = meshes.sun, .face_width = set.face_width};
  NamedMesh ring{.first = "ring", .second = "planet", .stiffness = meshes.ring, .face_width = set.face_width};
  const gearset::BasicRack planet_rack = rack_of(set, set.planet_heights);
  sun.standard = gearset::iso6336_stiffness({set.sun_teeth, set.planet_teeth, set.sun_shift, shift,
                                             rack_of(set, set.sun_heights), sun.stiffness.contact_ratio,
                                             material, set.helix_angle, set.web, planet_rack});
  // The standard takes the shift of a ring as that of an external gear: positive inward.
  ring.standard = gearset::iso6336_stiffness({set.planet_teeth, 0, shift, -set.ring_shift, planet_rack,
                                              ring.stiffness.contact_ratio, material, set.helix_angle,
                                              set.web, rack_of(set, set.ring_heights)});
  MeshStudy study;
  const gearset::MeanLoads loads = gearset::mean_loads(set, geometry, drivetrain.drive);
  sun.error = gearset::transmission_error(sun.stiffness.curve, loads.normal_force);
  ring.error = gearset::transmission_error(ring.stiffness.curve, loads.normal_force);
  if (set.flanks.contact == gearset::ToothContact::loaded) {
    const gearset::SetTeeth teeth = gearset::set_teeth(set, meshes);
    load_teeth(teeth.sun.teeth, loads.normal_force, sun);
    load_teeth(teeth.ring.teeth, loads.normal_force, ring);
    add_texts(gearset::edge_warnings(teeth, loads.normal_force), study.warnings);
  }
  if (set.helix_angle != 0.0) {
    study.axial = {geometry.base_helix_angle, loads, set.sun_thrust, gearset::axial_reactions(set, loads)};
  }
  const auto add = [&study](NamedMesh mesh, const std::vector<double>& lags) {
    for (std::size_t n = 0; n < lags.size(); ++n) {
      mesh.name = mesh.first + "-planet " + std::to_string(n + 1);
      mesh.phase = lags[n];
      study.meshes.push_back(mesh);
    }
  };
  if (drivetrain.rim == PlanetRim::elastic) study.planet_rim = derive(drivetrain).rim;
  add(sun, meshes.sun_lag);
  add(ring, meshes.ring_lag);
  study.gears = gear_circles(geometry);
  add_texts(gearset::tooth_warnings(geometry), study.warnings);
  add_texts(gearset::ring_sign_warnings(set, stated), study.warnings);
  add_texts(with_key_of_bore(gearset::foundation_warnings(meshes), drivetrain), study.warnings);
  warn_of_standard(sun, study.warnings);
  warn_of_standard(ring, study.warnings);
  return study;
}

std::vector<GearCircles> gear_circles(const gearset::WorkingGeometry& geometry) {
  const double sun_mesh = geometry.sun_mesh.working_pressure_angle,
               ring_mesh = geometry.ring_mesh.working_pressure_angle;
  std::vector<GearCircles> gears{circles_of("sun", geometry.sun, sun_mesh),
                                 circles_of("planet", geometry.planet, sun_mesh),
                                 circles_of("ring", geometry.ring, ring_mesh)};
  if (geometry.second)
    gears.push_back(circles_of("stepped_planet", *geometry.second, ring_mesh));
  else
    gears[1].at_ring = circles_of("planet", geometry.planet, ring_mesh).pitch;
  return gears;
}

}  // namespace orbearing::analysis
