#include "gearset/working_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gearset/involute.hpp"
#include "gearset/stepped_planet.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

// No involute mesh of practice works above this angle; beyond it a centre distance is a root of the equations
// only.
constexpr double largest_working_angle = 45.0 * constants::pi / 180.0;  // [rad]

struct BaseRadii {
  double sum;         // [m] sun and planet
  double difference;  // [m] ring and planet
};

double rack_angle(const PlanetarySet& set) {
  return transverse_pressure_angle(set.rack.pressure_angle, set.helix_angle);
}

BaseRadii base_radii(const PlanetarySet& set) {
  const double per_tooth = 0.5 * set.module / std::cos(set.helix_angle) * std::cos(rack_angle(set));
  return {per_tooth * (set.sun_teeth + set.planet_teeth), per_tooth * (set.ring_teeth - set.planet_teeth)};
}

// Sum (external) or difference (internal) of the shifts of a pair without backlash. Eqs. (2) and (3).
double pair_shift(const PlanetarySet& set, double teeth, double base_radius, double centre_distance) {
  const double working = involute(pressure_angle_at(base_radius, centre_distance));
  return teeth * (working - involute(rack_angle(set))) / (2.0 * std::tan(set.rack.pressure_angle));
}

double sun_mesh_shift(const PlanetarySet& set, double centre_distance) {
  return pair_shift(set, set.sun_teeth + set.planet_teeth, base_radii(set).sum, centre_distance);
}

double ring_mesh_shift(const PlanetarySet& set, double centre_distance) {
  return pair_shift(set, set.ring_teeth - set.planet_teeth, base_radii(set).difference, centre_distance);
}

[[noreturn]] void no_common_centre_distance() {
  throw std::domain_error(
      "no planet shift gives both meshes the same centre distance; choose ring teeth closer to sun + 2 "
      "planet teeth, or change the shifts of sun and ring");
}

// The planet's shift drops out of the sum of both meshes' equations, which grows with the distance. Eq. (4).
double common_centre_distance(const PlanetarySet& set) {
  const auto excess = [&set](double distance) {
    return sun_mesh_shift(set, distance) + ring_mesh_shift(set, distance) - set.sun_shift - set.ring_shift;
  };
  const auto [sum, difference] = base_radii(set);
  if (difference <= 0.0) no_common_centre_distance();
  const double low = std::max(sum, difference);
  const double high = std::min(sum, difference) / std::cos(largest_working_angle);
  if (!(low < high) || !(excess(low) <= 0.0) || !(excess(high) >= 0.0)) no_common_centre_distance();
  return bracketed_root(excess, low, high);
}

MeshGeometry sun_mesh(const PlanetarySet& set, const WorkingGeometry& geometry) {
  MeshGeometry mesh;
  mesh.working_pressure_angle = pressure_angle_at(base_radii(set).sum, geometry.centre_distance);
  mesh.path = external_contact_path(geometry.sun, geometry.planet, geometry.centre_distance);
  mesh.contact_ratio = contact_ratio(mesh.path, geometry.planet);
  return mesh;
}

MeshGeometry ring_mesh(const PlanetarySet& set, const WorkingGeometry& geometry) {
  MeshGeometry mesh;
  mesh.working_pressure_angle = pressure_angle_at(base_radii(set).difference, geometry.centre_distance);
  mesh.path = internal_contact_path(geometry.ring, geometry.planet, geometry.centre_distance);
  mesh.contact_ratio = contact_ratio(mesh.path, geometry.planet);
  return mesh;
}

// The ring and the second gear make the distance, at which the sun meshes with the first.
void close_stepped(const PlanetarySet& set, WorkingGeometry& geometry) {
  const double module = ring_module(set);
  geometry.second = make_external_tooth(set.stepped.teeth, set.stepped.shift.value_or(0.0), module,
                                        rack_of(set, set.planet_heights), set.helix_angle);
  const InternalMesh mesh =
      mesh_without_backlash(make_ring_tooth(set.ring_teeth, set.ring_shift, module,
                                            rack_of(set, set.ring_heights), set.helix_angle),
                            *geometry.second);
  geometry.ring = mesh.ring;
  geometry.ring_mesh = mesh.mesh;
  geometry.centre_distance = mesh.centre_distance;
  const double sum = base_radii(set).sum;
  if (!(mesh.centre_distance >= sum) || sum / mesh.centre_distance < std::cos(largest_working_angle))
    throw std::domain_error(
        "found a centre distance of " + millimetres(mesh.centre_distance) +
        " from the ring and the planet's second gear, at which sun and first gear cannot mesh: " +
        millimetres(sum) + " to " + millimetres(sum / std::cos(largest_working_angle)) +
        " is required; change teeth, module or shifts of the ring mesh");
}

}  // namespace

double angle_without_backlash(const ExternalTooth& gear, double teeth, double shifts) {
  constexpr double degree = constants::degree;
  const double value =
      involute(gear.pressure_angle) + 2.0 * std::tan(gear.normal_pressure_angle) * shifts / teeth;
  if (value < 0.0)
    throw std::domain_error("found shifts that bring the base circles together; a larger sum is required");
  const double angle = inverse_involute(value);
  if (angle > largest_working_angle)
    throw std::domain_error("found shifts that make the working pressure angle " +
                            decimal(angle / degree, 2) +
                            " deg; at most 45 deg is required: a smaller sum of shifts");
  return angle;
}

InternalMesh mesh_without_backlash(const RingTooth& ring, const ExternalTooth& inside) {
  if (ring.teeth <= inside.teeth)
    throw std::domain_error(
        "found a ring with as many teeth as the gear inside it or fewer; more are required");
  const double angle = angle_without_backlash(inside, ring.teeth - inside.teeth, ring.shift - inside.shift);
  InternalMesh found{ring, inside, (ring.base_radius - inside.base_radius) / std::cos(angle), {}};
  found.mesh.working_pressure_angle = angle;
  found.mesh.path = internal_contact_path(ring, inside, found.centre_distance);
  found.mesh.contact_ratio = contact_ratio(found.mesh.path, inside);
  return found;
}

double planet_working_radius(const WorkingGeometry& geometry, const MeshGeometry& mesh) {
  return geometry.planet.base_radius / std::cos(mesh.working_pressure_angle);
}

WorkingGeometry working_geometry(const PlanetarySet& set) {
  WorkingGeometry geometry;
  const double helix = set.helix_angle;
  const bool stepped = set.stepped.present();
  if (stepped)
    close_stepped(set, geometry);
  else
    geometry.centre_distance = common_centre_distance(set);
  geometry.planet_shift = sun_mesh_shift(set, geometry.centre_distance) - set.sun_shift;
  geometry.sun =
      make_external_tooth(set.sun_teeth, set.sun_shift, set.module, rack_of(set, set.sun_heights), helix);
  geometry.planet = make_external_tooth(set.planet_teeth, geometry.planet_shift, set.module,
                                        rack_of(set, set.planet_heights), helix);
  geometry.sun_mesh = sun_mesh(set, geometry);
  if (!stepped) {
    geometry.ring =
        make_ring_tooth(set.ring_teeth, set.ring_shift, set.module, rack_of(set, set.ring_heights), helix);
    geometry.ring_mesh = ring_mesh(set, geometry);
  }
  geometry.base_helix_angle = base_helix_angle(set.rack.pressure_angle, helix);
  geometry.overlap_ratio = overlap_ratio(set.face_width, set.module, helix);
  return geometry;
}

}  // namespace orbearing::gearset
