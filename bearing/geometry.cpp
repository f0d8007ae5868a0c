#include "bearing/geometry.hpp"

#include <boost/math/constants/constants.hpp>

namespace orbearing::bearing {

namespace {

using boost::math::double_constants::pi;

double ring_volume(double inner_diameter, double outer_diameter, double width) {
  return 0.25 * pi * (outer_diameter * outer_diameter - inner_diameter * inner_diameter) * width;
}

// Each pocket is cut through the whole height of the cage over the roller's length and diameter.
double pockets_volume(const CylindricalRollerBearing& bearing) {
  const double height = 0.5 * (bearing.cage.outer_diameter - bearing.cage.inner_diameter);
  return bearing.rollers * height * bearing.roller_length * bearing.roller_diameter;
}

void add_roller(const CylindricalRollerBearing& bearing, RollerBearingGeometry& geometry) {
  const double radius = geometry.roller_radius;
  geometry.roller_mass = bearing.material.density * pi * radius * radius * bearing.roller_length;
  geometry.roller_inertia = 0.5 * geometry.roller_mass * radius * radius;
}

void add_cage(const CylindricalRollerBearing& bearing, RollerBearingGeometry& geometry) {
  const Cage& cage = bearing.cage;
  const double volume =
      ring_volume(cage.inner_diameter, cage.outer_diameter, cage.width) - pockets_volume(bearing);
  const double mean_square_radius =
      0.125 * (cage.inner_diameter * cage.inner_diameter + cage.outer_diameter * cage.outer_diameter);
  geometry.cage_mass = cage.width > 0.0 ? cage.density * volume : 0.0;
  geometry.cage_inertia = geometry.cage_mass * mean_square_radius;
}

}  // namespace

RollerBearingGeometry geometry_of(const CylindricalRollerBearing& bearing) {
  RollerBearingGeometry geometry;
  geometry.pitch_radius = 0.5 * bearing.pitch_diameter;
  geometry.roller_radius = 0.5 * bearing.roller_diameter;
  geometry.inner_radius = geometry.pitch_radius - geometry.roller_radius - 0.25 * bearing.radial_clearance;
  geometry.outer_radius = geometry.pitch_radius + geometry.roller_radius + 0.25 * bearing.radial_clearance;
  add_roller(bearing, geometry);
  add_cage(bearing, geometry);
  geometry.outer_ring_mass = bearing.material.density * ring_volume(2.0 * geometry.outer_radius,
                                                                    bearing.outside_diameter, bearing.width);
  geometry.inner_ring_mass =
      bearing.material.density * ring_volume(bearing.bore, 2.0 * geometry.inner_radius, bearing.width);
  return geometry;
}

double equivalent_radius(const RollerBearingGeometry& geometry, Race race) {
  const double roller = geometry.roller_radius;
  if (race == Race::inner) return roller * geometry.inner_radius / (geometry.inner_radius + roller);
  return roller * geometry.outer_radius / (geometry.outer_radius - roller);
}

// The rolling points of both races move with half the sum of their surface speeds at the roller's centre.
double kinematic_cage_speed(const RollerBearingGeometry& geometry, double inner_speed, double outer_speed) {
  const double gamma = geometry.roller_radius / geometry.pitch_radius;
  return 0.5 * (inner_speed * (1.0 - gamma) + outer_speed * (1.0 + gamma));
}

double kinematic_roller_spin(const RollerBearingGeometry& geometry, double inner_speed, double outer_speed) {
  const double gamma = geometry.roller_radius / geometry.pitch_radius;
  return (outer_speed * (1.0 + gamma) - inner_speed * (1.0 - gamma)) / (2.0 * gamma);
}

}  // namespace orbearing::bearing
