#include <algorithm>
#include <cmath>
#include <string>

#include "gearset/checks.hpp"
#include "gearset/involute.hpp"
#include "gearset/message.hpp"

namespace orbearing::gearset {

namespace {

constexpr const char* place = "gearset.profile_shift";

// Gears that just reach the end of an involute are sound; this keeps round-off from warning about them.
constexpr double reach_tolerance = 1e-9;  // [module]

void warn_undercut(const ExternalTooth& tooth, const std::string& gear, Warnings& warnings) {
  if (!tooth.undercut) return;
  warnings.push_back({place, "the " + gear + " is undercut: its profile shift " + decimal(tooth.shift, 4) +
                                 " lies below the limit " + decimal(least_shift_without_undercut(tooth), 4) +
                                 "; its involute begins at a radius of " + millimetres(tooth.form_radius) +
                                 " (base circle " + millimetres(tooth.base_radius) +
                                 ") and the path of contact ends there"});
}

// `reached` is the tangent length on `tooth` that the other gear's tip calls for.
void warn_reach(double reached, const ExternalTooth& tooth, const std::string& other, const std::string& gear,
                Warnings& warnings) {
  const double foot = tangent_length(tooth.base_radius, tooth.form_radius);
  const double tolerance = reach_tolerance * tooth.module;
  if (reached >= foot - tolerance) return;
  const std::string limit =
      reached < -tolerance ? "base circle, where there is no involute" : "form circle, into the root fillet";
  warnings.push_back({place, "the tips of the " + other + " reach below the " + gear + "'s " + limit +
                                 "; the path of contact ends at the " + gear + "'s form radius " +
                                 millimetres(tooth.form_radius) +
                                 ", and the tips need relief or a smaller addendum"});
}

void warn_all_reaches(const WorkingGeometry& g, Warnings& warnings) {
  const double sun_line = g.centre_distance * std::sin(g.sun_mesh.working_pressure_angle);
  const double ring_line = g.centre_distance * std::sin(g.ring_mesh.working_pressure_angle);
  const double sun_tip = tangent_length(g.sun.base_radius, g.sun.tip_radius);
  const double planet_tip = tangent_length(g.planet.base_radius, g.planet.tip_radius);
  const double ring_tip = tangent_length(g.ring.base_radius, std::max(g.ring.tip_radius, g.ring.base_radius));
  warn_reach(sun_line - sun_tip, g.planet, "sun", "planet", warnings);
  warn_reach(ring_tip - ring_line, g.planet, "ring", "planet", warnings);
  warn_reach(sun_line - planet_tip, g.sun, "planet", "sun", warnings);
  if (g.ring.tip_radius < g.ring.base_radius) {
    warnings.push_back({place, "the ring's tip circle " + millimetres(g.ring.tip_radius) +
                                   " lies inside its base circle " + millimetres(g.ring.base_radius) +
                                   ", where there is no involute; raise the ring's shift"});
  }
}

void warn_clearance(double clearance, double module, const std::string& tip, const std::string& root,
                    Warnings& warnings) {
  if (clearance >= -reach_tolerance * module) return;
  warnings.push_back({place, "the tips of the " + tip + " dig into the roots of the " + root + " by " +
                                 millimetres(-clearance) + "; raise the clearance or change the shifts"});
}

// Shifted external gears come closer than the sum of their shifts asks; ring and planet never lose clearance
// so.
void warn_all_clearances(const WorkingGeometry& g, Warnings& warnings) {
  const double a = g.centre_distance;
  warn_clearance(a - g.sun.tip_radius - g.planet.root_radius, g.sun.module, "sun", "planet", warnings);
  warn_clearance(a - g.planet.tip_radius - g.sun.root_radius, g.sun.module, "planet", "sun", warnings);
}

void warn_contact_ratio(const MeshGeometry& mesh, const std::string& name, Warnings& warnings) {
  if (mesh.contact_ratio >= 1.0) return;
  warnings.push_back({place, "the contact ratio of the " + name + " mesh is " +
                                 decimal(mesh.contact_ratio, 3) +
                                 "; at least 1 is needed for continuous drive"});
}

void warn_fouling(const WorkingGeometry& geometry, Warnings& warnings) {
  const double clearance = ring_tip_clearance(geometry);
  if (clearance >= 0.0) return;
  warnings.push_back(
      {place, "the tips of planet and ring foul each other outside the path of contact, by " +
                  millimetres(-clearance) +
                  " along the ring's tip circle; use fewer planet teeth or a smaller addendum"});
}

}  // namespace

double ring_tip_clearance(const WorkingGeometry& geometry) {
  const double a = geometry.centre_distance;
  const double planet_tip = geometry.planet.tip_radius;
  const double ring_tip = std::max(geometry.ring.tip_radius, geometry.ring.base_radius);
  const double cos_planet = (ring_tip * ring_tip - a * a - planet_tip * planet_tip) / (2.0 * a * planet_tip);
  const double cos_ring = (ring_tip * ring_tip + a * a - planet_tip * planet_tip) / (2.0 * a * ring_tip);
  if (std::abs(cos_planet) >= 1.0 || std::abs(cos_ring) >= 1.0) return ring_tip;
  const double planet_angle =
      std::acos(cos_planet) + involute(pressure_angle_at(geometry.planet.base_radius, planet_tip));
  const double ring_angle =
      std::acos(cos_ring) + involute(pressure_angle_at(geometry.ring.base_radius, ring_tip));
  const int planet_teeth = geometry.planet.teeth;
  const int ring_teeth = geometry.ring.teeth;
  const double working = involute(geometry.ring_mesh.working_pressure_angle);
  const double angle =
      (planet_teeth * planet_angle + (ring_teeth - planet_teeth) * working) / ring_teeth - ring_angle;
  return ring_tip * angle;
}

Warnings tooth_warnings(const WorkingGeometry& geometry) {
  Warnings warnings;
  warn_undercut(geometry.sun, "sun", warnings);
  warn_undercut(geometry.planet, "planet", warnings);
  warn_all_reaches(geometry, warnings);
  warn_all_clearances(geometry, warnings);
  warn_fouling(geometry, warnings);
  warn_contact_ratio(geometry.sun_mesh, "sun", warnings);
  warn_contact_ratio(geometry.ring_mesh, "ring", warnings);
  return warnings;
}

}  // namespace orbearing::gearset
