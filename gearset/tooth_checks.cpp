#include <algorithm>
#include <cmath>
#include <string>

#include "gearset/checks.hpp"
#include "gearset/involute.hpp"
#include "gearset/tooth_form.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

constexpr const char* kSetShift = "gearset.profile_shift";
constexpr double kUsualShift = 0.6;  // [module]  Assumption: sets in use are within -0.5 and 0.5

void check_ring_reach(const InternalMesh& mesh, const std::string& inside, ToothWarnings& warnings) {
  const double line = mesh.centre_distance * std::sin(mesh.mesh.working_pressure_angle);
  const double tip =
      tangent_length(mesh.ring.base_radius, std::max(mesh.ring.tip_radius, mesh.ring.base_radius));
  warnings.reach(tip - line, mesh.inside, "ring", inside);
}

void check_ring_tip(const RingTooth& ring, ToothWarnings& warnings) {
  if (ring.tip_radius >= ring.base_radius) return;
  warnings.list.push_back({warnings.position, "the ring's tip circle " + millimetres(ring.tip_radius) +
                                                  " lies inside its base circle " +
                                                  millimetres(ring.base_radius) +
                                                  ", where there is no involute; raise the ring's shift"});
}

// A ring and the gear inside it lose clearance where their addenda are their own.
void check_ring_clearances(const InternalMesh& mesh, const std::string& inside, ToothWarnings& warnings) {
  const double a = mesh.centre_distance;
  warnings.clearance(mesh.ring.root_radius - a - mesh.inside.tip_radius, mesh.ring.module, inside, "ring");
  warnings.clearance(mesh.ring.tip_radius - a - mesh.inside.root_radius, mesh.ring.module, "ring", inside);
}

void check_fouling(const InternalMesh& mesh, const std::string& inside, ToothWarnings& warnings) {
  const double clearance = ring_tip_clearance(mesh);
  if (clearance >= 0.0) return;
  warnings.list.push_back(
      {warnings.position, "the tips of " + inside +
                              " and ring foul each other outside the path of contact, by " +
                              millimetres(-clearance) + " along the ring's tip circle; use fewer " + inside +
                              " teeth or a smaller addendum"});
}

void check_reaches(const WorkingGeometry& g, const std::string& inside, ToothWarnings& warnings) {
  const double sun_line = g.centre_distance * std::sin(g.sun_mesh.working_pressure_angle);
  const double sun_tip = tangent_length(g.sun.base_radius, g.sun.tip_radius);
  const double planet_tip = tangent_length(g.planet.base_radius, g.planet.tip_radius);
  warnings.reach(sun_line - sun_tip, g.planet, "sun", "planet");
  check_ring_reach(ring_mesh_of(g), inside, warnings);
  warnings.reach(sun_line - planet_tip, g.sun, "planet", "sun");
  check_ring_tip(g.ring, warnings);
}

// Shifted external gears have a smaller centre distance than the sum of their shifts requires.
void check_clearances(const WorkingGeometry& g, const std::string& inside, ToothWarnings& warnings) {
  const double a = g.centre_distance;
  warnings.clearance(a - g.sun.tip_radius - g.planet.root_radius, g.sun.module, "sun", "planet");
  warnings.clearance(a - g.planet.tip_radius - g.sun.root_radius, g.sun.module, "planet", "sun");
  check_ring_clearances(ring_mesh_of(g), inside, warnings);
}

// The derived shift: a wrong number of teeth shows in it.
void check_planet_shift(const WorkingGeometry& g, ToothWarnings& warnings) {
  if (std::abs(g.planet_shift) <= kUsualShift) return;
  const auto number = [](int teeth) { return std::to_string(teeth); };
  const std::string teeth = number(g.sun.teeth) + ", " + number(g.planet.teeth) +
                            (g.second ? ", " + number(g.second->teeth) : "") + " and " + number(g.ring.teeth);
  const std::string standard =
      g.second ? ""
               : "; a ring of sun + 2 planet = " + number(g.sun.teeth + 2 * g.planet.teeth) +
                     " teeth requires none where sun and ring have none";
  warnings.list.push_back(
      {"gearset.teeth", "the planet's profile shift " + decimal(g.planet_shift, 4) +
                            ", derived from the centre distance, is outside the usual range, -" +
                            decimal(kUsualShift, 1) + " to " + decimal(kUsualShift, 1) + ". Sun, planet" +
                            (g.second ? ", its second gear" : "") + " and ring have " + teeth + " teeth" +
                            standard + ". The ring mesh has a working pressure angle of " +
                            decimal(g.ring_mesh.working_pressure_angle / constants::degree, 1) +
                            " deg. Check the numbers of teeth and the stated shifts"});
}

}  // namespace

void warn_of_external_mesh(const ExternalTooth& tooth, const ExternalTooth& mate, double distance,
                           double working_angle, const std::string& gear, const std::string& other,
                           ToothWarnings& warnings) {
  const double line = distance * std::sin(working_angle);
  warnings.reach(line - tangent_length(mate.base_radius, mate.tip_radius), tooth, other, gear);
  warnings.clearance(distance - mate.tip_radius - tooth.root_radius, tooth.module, other, gear);
}

void warn_of_internal_mesh(const InternalMesh& mesh, const std::string& inside, ToothWarnings& warnings) {
  check_ring_reach(mesh, inside, warnings);
  check_ring_tip(mesh.ring, warnings);
  check_ring_clearances(mesh, inside, warnings);
  check_fouling(mesh, inside, warnings);
}

double ring_tip_clearance(const WorkingGeometry& geometry) {
  return ring_tip_clearance(ring_mesh_of(geometry));
}

double ring_tip_clearance(const InternalMesh& mesh) {
  const double a = mesh.centre_distance;
  const double planet_tip = mesh.inside.tip_radius;
  const double ring_tip = std::max(mesh.ring.tip_radius, mesh.ring.base_radius);
  const double cos_planet = (ring_tip * ring_tip - a * a - planet_tip * planet_tip) / (2.0 * a * planet_tip);
  const double cos_ring = (ring_tip * ring_tip + a * a - planet_tip * planet_tip) / (2.0 * a * ring_tip);
  if (std::abs(cos_planet) >= 1.0 || std::abs(cos_ring) >= 1.0) return ring_tip;
  const double planet_angle =
      std::acos(cos_planet) + involute(pressure_angle_at(mesh.inside.base_radius, planet_tip));
  const double ring_angle =
      std::acos(cos_ring) + involute(pressure_angle_at(mesh.ring.base_radius, ring_tip));
  const int planet_teeth = mesh.inside.teeth;
  const int ring_teeth = mesh.ring.teeth;
  const double working = involute(mesh.mesh.working_pressure_angle);
  const double angle =
      (planet_teeth * planet_angle + (ring_teeth - planet_teeth) * working) / ring_teeth - ring_angle;
  return ring_tip * angle;
}

Warnings tooth_warnings(const WorkingGeometry& geometry) {
  ToothWarnings warnings{kSetShift, {}};
  check_planet_shift(geometry, warnings);
  warnings.undercut(geometry.sun, "sun");
  warnings.undercut(geometry.planet, "planet");
  if (geometry.second) warnings.undercut(*geometry.second, "planet's second gear");
  const std::string inside = geometry.second ? "planet's second gear" : "planet";
  check_reaches(geometry, inside, warnings);
  check_clearances(geometry, inside, warnings);
  check_fouling(ring_mesh_of(geometry), inside, warnings);
  warnings.contact_ratio(geometry.sun_mesh.contact_ratio, "sun mesh");
  warnings.contact_ratio(geometry.ring_mesh.contact_ratio, "ring mesh");
  return warnings.list;
}

}  // namespace orbearing::gearset
