#include "gearset/planet_pair.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gearset/checks.hpp"
#include "gearset/tooth_form.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

using Eigen::Vector2d;

// Two external gears without backlash.
struct ExternalMesh {
  double distance = 0.0;  // [m]
  MeshGeometry mesh;      // path from the tangent point of the first gear's base circle
};

ExternalMesh mesh_of(const ExternalTooth& first, const ExternalTooth& second) {
  const double angle = angle_without_backlash(first, first.teeth + second.teeth, first.shift + second.shift);
  ExternalMesh found{(first.base_radius + second.base_radius) / std::cos(angle), {}};
  found.mesh.working_pressure_angle = angle;
  found.mesh.path = external_contact_path(first, second, found.distance);
  found.mesh.contact_ratio = contact_ratio(found.mesh.path, second);
  return found;
}

// Between two sides of a triangle, the third lies opposite. Eq. (45).
double angle_between(double one, double other, double opposite) {
  const double cosine = (one * one + other * other - opposite * opposite) / (2.0 * one * other);
  if (std::abs(cosine) < 1.0) return std::acos(cosine);
  throw std::domain_error("found distances of " + millimetres(one) +
                          " from the sun's axis to the first planet's, " + millimetres(other) +
                          " to the second planet's and " + millimetres(opposite) +
                          " between both, which make no triangle; planets in mesh with each other are "
                          "required: change the teeth of the planets or the ring");
}

Vector2d direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}
Vector2d ahead_of(const Vector2d& outward) {
  return {-outward.y(), outward.x()};
}

// Sum of the forces of all meshes on one planet, x outward from the sun's axis through the first planet.
// `push` [N] is the force of each mesh along its line of action, positive where the sun drives the first
// planet on. Eq. (47).
Vector2d force_on(const PlanetPairGeometry& g, const PlanetOfPair& planet, double push) {
  const double sense = planet.pair.side == PairSide::ahead ? 1.0 : -1.0, size = std::abs(push);
  const Vector2d first(g.first_distance, 0.0), outward = direction(sense * g.angle);
  const Vector2d line = (g.second_distance * outward - first).normalized();
  const auto of_mesh = [&](const MeshGeometry& mesh, const Vector2d& away, const Vector2d& along) {
    const double angle = mesh.working_pressure_angle;
    return Vector2d(size * std::sin(angle) * away + push * std::cos(angle) * along);
  };
  const Vector2d from_first = of_mesh(g.planet_mesh, line, -ahead_of(line));
  if (planet.second) return from_first + of_mesh(g.ring_mesh, -outward, -ahead_of(outward));
  return of_mesh(g.sun_mesh, Vector2d::UnitX(), Vector2d::UnitY()) - from_first;
}

}  // namespace

PlanetPairGeometry planet_pair_geometry(const PlanetarySet& set, const SecondPlanet& pair) {
  PlanetPairGeometry g;
  const auto tooth = [&](int teeth, double shift, const OwnHeights& own) {
    return make_external_tooth(teeth, shift, set.module, rack_of(set, own), set.helix_angle);
  };
  g.sun = tooth(set.sun_teeth, set.sun_shift, set.sun_heights);
  g.first = tooth(set.planet_teeth, pair.first_shift, set.planet_heights);
  g.second = tooth(pair.teeth, pair.shift, set.planet_heights);
  const ExternalMesh sun = mesh_of(g.sun, g.first), between = mesh_of(g.first, g.second);
  const InternalMesh ring =
      mesh_without_backlash(make_ring_tooth(set.ring_teeth, set.ring_shift, set.module,
                                            rack_of(set, set.ring_heights), set.helix_angle),
                            g.second);
  g.ring = ring.ring;
  g.first_distance = sun.distance;
  g.between = between.distance;
  g.second_distance = ring.centre_distance;
  g.sun_mesh = sun.mesh;
  g.planet_mesh = between.mesh;
  g.ring_mesh = ring.mesh;
  g.angle = angle_between(g.first_distance, g.second_distance, g.between);
  return g;
}

WorkingGeometry geometry_of_planet(const PlanetarySet& set, const PlanetOfPair& planet) {
  const PlanetPairGeometry g = planet_pair_geometry(set, planet.pair);
  WorkingGeometry own;
  own.centre_distance = planet.second ? g.second_distance : g.first_distance;
  own.planet = planet.second ? g.second : g.first;
  own.planet_shift = own.planet.shift;
  own.sun = planet.second ? g.first : g.sun;
  own.sun_mesh = planet.second ? g.planet_mesh : g.sun_mesh;
  own.ring = g.ring;
  own.ring_mesh = g.ring_mesh;
  return own;
}

WillisTeeth willis_teeth_of_pairs(const PlanetarySet& set) {
  return {set.sun_teeth, set.planet_teeth, -set.ring_teeth};
}

MeanLoads mean_loads_of_planet(const PlanetarySet& set, const PlanetOfPair& planet,
                               const MemberRatios& ratios, const Drive& drive) {
  MeanLoads loads = member_loads(ratios, drive);
  const PlanetPairGeometry g = planet_pair_geometry(set, planet.pair);
  const double rolling = (loads.sun_speed - loads.carrier_speed) * set.sun_teeth;
  loads.planet_speed_relative = planet.second ? rolling / planet.pair.teeth : -rolling / set.planet_teeth;
  const double push = loads.sun_torque / (set.planets * g.sun.base_radius);
  loads.normal_force = loads.ring_normal_force = loads.tooth_force = std::abs(push);
  const double turned = planet.second ? (planet.pair.side == PairSide::ahead ? g.angle : -g.angle) : 0.0;
  const Vector2d outward = direction(turned), force = force_on(g, planet, push);
  loads.radial_force = force.dot(outward);
  loads.tangential_force = force.dot(ahead_of(outward));
  return loads;
}

namespace {

// Axes [m] of all planets round the carrier, with their tip radii.
struct Disc {
  Vector2d axis;
  double tip = 0.0;
  int pair = 0;
};

std::vector<Disc> discs_of(const PlanetarySet& set, const PlanetPairGeometry& g) {
  std::vector<Disc> discs;
  for (int n = 0; n < set.planets; ++n) {
    const double angle = constants::two_pi * n / set.planets;
    discs.push_back({g.first_distance * direction(angle), g.first.tip_radius, n});
    discs.push_back({g.second_distance * direction(angle + g.angle), g.second.tip_radius, n});
  }
  return discs;
}

void check_room(const PlanetarySet& set, const PlanetPairGeometry& g, Warnings& problems) {
  const std::vector<Disc> discs = discs_of(set, g);
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = (discs[i].axis - discs[j].axis).norm(), reach = discs[i].tip + discs[j].tip;
      if (discs[i].pair == discs[j].pair || apart > reach) continue;
      problems.push_back({"gearset.planets", "found planets of neighbouring pairs whose axes lie " +
                                                 millimetres(apart) + " apart; more than their tip radii, " +
                                                 millimetres(reach) + ", is required; use fewer pairs"});
      return;
    }
  if (g.second_distance - g.second.tip_radius > g.sun.tip_radius) return;
  problems.push_back({"gearset.second_planet.teeth",
                      "found second planets that reach the sun; " + millimetres(g.sun.tip_radius) +
                          " from its axis must be free; use fewer teeth of the second planet"});
}

void check_first_in_ring(const PlanetPairGeometry& g, Warnings& problems) {
  if (g.first_distance + g.first.tip_radius < g.ring.tip_radius) return;
  problems.push_back({"gearset.teeth.planet", "found first planets that reach the ring; " +
                                                  millimetres(g.first_distance + g.first.tip_radius) +
                                                  " from the sun's axis, less than the ring's tip radius, " +
                                                  millimetres(g.ring.tip_radius) +
                                                  ", is required; use fewer teeth"});
}

void check_bores(const PlanetarySet& set, const PlanetPairGeometry& g, Warnings& problems) {
  const double root = 2.0 * std::min(g.first.root_radius, g.second.root_radius);
  if (set.planet_bore < root) return;
  problems.push_back(
      {"bearing.outside_diameter", "found a planet bore of " + millimetres(set.planet_bore) +
                                       "; less than the root diameter of both planets of a pair, " +
                                       millimetres(root) + ", is required"});
}

}  // namespace

Warnings pair_tooth_warnings(const PlanetarySet& set, const SecondPlanet& pair) {
  const PlanetPairGeometry g = planet_pair_geometry(set, pair);
  const std::string sun = "sun", first = "first planet", second = "second planet";
  ToothWarnings warnings{"gearset.profile_shift", {}};
  warnings.undercut(g.sun, sun);
  warnings.undercut(g.first, first);
  warnings.undercut(g.second, second);
  const auto external = [&](const ExternalTooth& one, const std::string& name, const ExternalTooth& other,
                            const std::string& other_name, double distance, const MeshGeometry& mesh) {
    const double angle = mesh.working_pressure_angle;
    warn_of_external_mesh(one, other, distance, angle, name, other_name, warnings);
    warn_of_external_mesh(other, one, distance, angle, other_name, name, warnings);
  };
  external(g.sun, sun, g.first, first, g.first_distance, g.sun_mesh);
  external(g.first, first, g.second, second, g.between, g.planet_mesh);
  warn_of_internal_mesh({g.ring, g.second, g.second_distance, g.ring_mesh}, second, warnings);
  warnings.contact_ratio(g.sun_mesh.contact_ratio, "sun mesh");
  warnings.contact_ratio(g.planet_mesh.contact_ratio, "mesh of both planets");
  warnings.contact_ratio(g.ring_mesh.contact_ratio, "ring mesh");
  return warnings.list;
}

Warnings pair_problems(const PlanetarySet& set, const SecondPlanet& pair) {
  Warnings problems;
  const int difference = set.ring_teeth - set.sun_teeth;  // Eq. (44)
  if (difference <= 0 || difference % set.planets != 0)
    problems.push_back(
        {"gearset.planets", "found " + std::to_string(set.planets) +
                                " equally spaced pairs of planets; a divisor of ring - sun teeth = " +
                                std::to_string(difference) +
                                " is required; change the number of pairs or the teeth"});
  for (const Warning& problem : rack_problems(set.rack, "gearset")) problems.push_back(problem);
  try {
    const PlanetPairGeometry g = planet_pair_geometry(set, pair);
    for (const ExternalTooth* tooth : {&g.sun, &g.first, &g.second})
      if (!(half_thickness_angle(*tooth, tooth->tip_radius) > 0.0))
        problems.push_back({"gearset.profile_shift",
                            "found flanks that cross before the tip circle of a gear of " +
                                std::to_string(tooth->teeth) +
                                " teeth; a tooth with a tip is required; lower its shift or the addendum"});
    check_room(set, g, problems);
    check_first_in_ring(g, problems);
    check_bores(set, g, problems);
    for (const auto& [mesh, name] :
         {std::pair{&g.sun_mesh, "sun"}, {&g.planet_mesh, "planets'"}, {&g.ring_mesh, "ring"}})
      if (!(mesh->path.length() > 0.0))
        problems.push_back({"gearset.profile_shift", std::string("found no path of contact in the ") + name +
                                                         " mesh; teeth that reach each other are required"});
  } catch (const std::domain_error& error) {
    problems.push_back({"gearset.second_planet.teeth", error.what()});
  }
  return problems;
}

}  // namespace orbearing::gearset
