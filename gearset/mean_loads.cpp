#include "gearset/mean_loads.hpp"

#include <cassert>
#include <cmath>

#include "gearset/kinematics.hpp"

namespace orbearing::gearset {

MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const Drive& drive) {
  assert(set.planets > 0);
  const Speeds speeds = member_speeds(set, drive);
  const Torques torques = member_torques(set, drive);
  const double sun_angle = geometry.sun_mesh.working_pressure_angle;
  const double ring_angle = geometry.ring_mesh.working_pressure_angle;

  MeanLoads loads;
  loads.sun_speed = speeds.sun;
  loads.ring_speed = speeds.ring;
  loads.carrier_speed = speeds.carrier;
  loads.planet_speed_relative = speeds.planet_relative;
  loads.sun_torque = torques.sun;
  loads.ring_torque = torques.ring;
  loads.carrier_torque = torques.carrier;
  const double signed_normal_force = torques.sun / (set.planets * geometry.sun.base_radius);
  loads.normal_force = std::abs(signed_normal_force);
  loads.tangential_force = signed_normal_force * (std::cos(sun_angle) + std::cos(ring_angle));
  // Teeth only push: the sun outward and the ring inward, whichever flank carries.
  loads.radial_force = loads.normal_force * (std::sin(sun_angle) - std::sin(ring_angle));
  return loads;
}

double planet_tangential_load(double carrier_torque, int planets, double centre_distance) {
  assert(planets > 0 && centre_distance > 0.0);
  return std::abs(carrier_torque) / (planets * centre_distance);
}

}  // namespace orbearing::gearset
