#include "bearing/geometry.hpp"
#include "mechanics/constants.hpp"

#include <cmath>

namespace orbearing::bearing {

namespace {

using constants::pi;

double ring_volume(double inner_diameter, double outer_diameter, double width) {
  return 0.25 * pi * (outer_diameter * outer_diameter - inner_diameter * inner_diameter) * width;
}

// Whether a race is cut into pin or planet: its diameter is that of the seat but for round-off.
bool without_ring(double seat_diameter, double race_diameter) {
  constexpr double round_off = 1e-6;
  return std::abs(seat_diameter - race_diameter) < round_off * race_diameter;
}

// Volume of the inner ring; for rollers that run on the pin itself, of the pin beneath the race, which is the
// moving part.
double pin_volume(const Bearing& bearing, double race_diameter) {
  const double bore = bearing.inner.seat_diameter;
  return ring_volume(without_ring(bore, race_diameter) ? 0.0 : bore, race_diameter, bearing.width);
}

// Each pocket is cut through the whole height of the cage, over a roller's length and diameter or a ball's
// section.
double pockets_volume(const CylindricalRollers& rollers, double height) {
  return rollers.count * height * rollers.length * rollers.diameter;
}
double pockets_volume(const Balls& balls, double height) {
  return balls.count * height * 0.25 * pi * balls.diameter * balls.diameter;
}

void add_element(const CylindricalRollers& rollers, double density, BearingGeometry& geometry) {
  const double radius = geometry.element_radius;
  geometry.element_mass = density * pi * radius * radius * rollers.length;
  geometry.element_inertia = 0.5 * geometry.element_mass * radius * radius;
}
void add_element(const Balls&, double density, BearingGeometry& geometry) {
  const double radius = geometry.element_radius;
  geometry.element_mass = density * 4.0 / 3.0 * pi * radius * radius * radius;
  geometry.element_inertia = 0.4 * geometry.element_mass * radius * radius;
}

void add_cage(const Cage& cage, double pockets, BearingGeometry& geometry) {
  const double volume = ring_volume(cage.inner_diameter, cage.outer_diameter, cage.width) - pockets;
  const double mean_square_radius =
      0.125 * (cage.inner_diameter * cage.inner_diameter + cage.outer_diameter * cage.outer_diameter);
  geometry.cage_mass = cage.width > 0.0 ? cage.density * volume : 0.0;
  geometry.cage_inertia = geometry.cage_mass * mean_square_radius;
}

// From the pitch circle to the race [m]: half an element, of a groove that meets it at an angle somewhat
// less.
double race_distance(const Bearing& bearing, const Ring& ring) {
  const double diameter = bearing.element_diameter();
  if (bearing.has_rollers()) return 0.5 * diameter;
  const double cosine = std::cos(bearing.contact_angle());
  return 0.5 * diameter * cosine + ring.osculation * diameter * (1.0 - cosine);
}

}  // namespace

BearingGeometry geometry_of(const Bearing& bearing) {
  const Cage& cage = bearing.cage;
  const double density = bearing.material.density;
  BearingGeometry geometry;
  geometry.pitch_radius = 0.5 * bearing.pitch_diameter;
  geometry.element_radius = 0.5 * bearing.element_diameter();
  geometry.slenderness = slenderness(bearing);
  geometry.inner_radius =
      geometry.pitch_radius - race_distance(bearing, bearing.inner) - 0.25 * bearing.radial_clearance;
  geometry.outer_radius =
      geometry.pitch_radius + race_distance(bearing, bearing.outer) + 0.25 * bearing.radial_clearance;
  std::visit(
      [&](const auto& elements) {
        add_element(elements, density, geometry);
        add_cage(cage, pockets_volume(elements, 0.5 * (cage.outer_diameter - cage.inner_diameter)), geometry);
      },
      bearing.elements);
  geometry.outer_ring_mass =
      density * ring_volume(2.0 * geometry.outer_radius, bearing.outer.seat_diameter, bearing.width);
  geometry.inner_ring_mass = density * pin_volume(bearing, 2.0 * geometry.inner_radius);
  return geometry;
}

bool has_outer_ring(const Bearing& bearing, const BearingGeometry& geometry) {
  return !without_ring(bearing.outer.seat_diameter, 2.0 * geometry.outer_radius);
}

double equivalent_radius(const BearingGeometry& geometry, Race race) {
  const double roller = geometry.element_radius;
  if (race == Race::inner) return roller * geometry.inner_radius / (geometry.inner_radius + roller);
  return roller * geometry.outer_radius / (geometry.outer_radius - roller);
}

profile::DesignLoad design_under(const Bearing& bearing, double load) {
  return {.load = load,
          .length = bearing.rollers().length,
          .equivalent_radius = equivalent_radius(geometry_of(bearing), Race::inner),
          .material = bearing.material};
}

void put_profile(const profile::StatedProfile& stated, Bearing& bearing) {
  if (!stated.kind) return;
  bearing.rollers().profile =
      profile::profile_of(stated, bearing.rollers().diameter, design_under(bearing, 0.0));
}

// The rolling points of both races move with half the sum of their surface speeds at the roller's centre.
double kinematic_cage_speed(double slenderness, double inner_speed, double outer_speed) {
  return 0.5 * (inner_speed * (1.0 - slenderness) + outer_speed * (1.0 + slenderness));
}

double kinematic_cage_speed(const BearingGeometry& geometry, double inner_speed, double outer_speed) {
  return kinematic_cage_speed(geometry.slenderness, inner_speed, outer_speed);
}

double kinematic_roller_spin(const BearingGeometry& geometry, double inner_speed, double outer_speed) {
  const double gamma = geometry.slenderness;
  return (outer_speed * (1.0 + gamma) - inner_speed * (1.0 - gamma)) / (2.0 * gamma);
}

}  // namespace orbearing::bearing
