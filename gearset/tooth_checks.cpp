#include <algorithm>
#include <cmath>

#include "gearset/checks.hpp"
#include "gearset/involute.hpp"
#include "gearset/tooth_form.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

namespace {

constexpr const char* kSetShift = "gearset.profile_shift";

void check_reaches(const WorkingGeometry& g, ToothWarnings& warnings) {
  const double sun_line = g.centre_distance * std::sin(g.sun_mesh.working_pressure_angle);
  const double ring_line = g.centre_distance * std::sin(g.ring_mesh.working_pressure_angle);
  const double sun_tip = tangent_length(g.sun.base_radius, g.sun.tip_radius);
  const double planet_tip = tangent_length(g.planet.base_radius, g.planet.tip_radius);
  const double ring_tip = tangent_length(g.ring.base_radius, std::max(g.ring.tip_radius, g.ring.base_radius));
  warnings.reach(sun_line - sun_tip, g.planet, "sun", "planet");
  warnings.reach(ring_tip - ring_line, g.planet, "ring", "planet");
  warnings.reach(sun_line - planet_tip, g.sun, "planet", "sun");
  if (g.ring.tip_radius < g.ring.base_radius) {
    warnings.list.push_back({kSetShift, "the ring's tip circle " + millimetres(g.ring.tip_radius) +
                                            " lies inside its base circle " +
                                            millimetres(g.ring.base_radius) +
                                            ", where there is no involute; raise the ring's shift"});
  }
}

// Shifted external gears come closer than the sum of their shifts asks; ring and planet lose clearance where
// their addenda are their own.
void check_clearances(const WorkingGeometry& g, ToothWarnings& warnings) {
  const double a = g.centre_distance;
  warnings.clearance(a - g.sun.tip_radius - g.planet.root_radius, g.sun.module, "sun", "planet");
  warnings.clearance(a - g.planet.tip_radius - g.sun.root_radius, g.sun.module, "planet", "sun");
  warnings.clearance(g.ring.root_radius - a - g.planet.tip_radius, g.ring.module, "planet", "ring");
  warnings.clearance(g.ring.tip_radius - a - g.planet.root_radius, g.ring.module, "ring", "planet");
}

void check_fouling(const WorkingGeometry& geometry, ToothWarnings& warnings) {
  const double clearance = ring_tip_clearance(geometry);
  if (clearance >= 0.0) return;
  warnings.list.push_back(
      {kSetShift, "the tips of planet and ring foul each other outside the path of contact, by " +
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
  ToothWarnings warnings{kSetShift, {}};
  warnings.undercut(geometry.sun, "sun");
  warnings.undercut(geometry.planet, "planet");
  check_reaches(geometry, warnings);
  check_clearances(geometry, warnings);
  check_fouling(geometry, warnings);
  warnings.contact_ratio(geometry.sun_mesh.contact_ratio, "sun mesh");
  warnings.contact_ratio(geometry.ring_mesh.contact_ratio, "ring mesh");
  return warnings.list;
}

}  // namespace orbearing::gearset
