#include "gearset/mean_loads.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::gearset {

namespace {

MeanLoads loads_of(const PlanetarySet& set, const WorkingGeometry& geometry, const Speeds& speeds,
                   const Torques& torques) {
  assert(set.planets > 0);
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

}  // namespace

MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const Drive& drive) {
  return loads_of(set, geometry, member_speeds(set, drive), member_torques(set, drive));
}

MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const MemberRatios& ratios,
                     const Drive& drive) {
  mechanics::require_positive(drive.speed, "speed of the motor");
  mechanics::require_positive(drive.power, "power of the motor");
  const double sense = ratios.speed.carrier < 0.0 ? -1.0 : 1.0;
  const double speed = sense * drive.speed;                 // [rad/s]
  const double torque = sense * drive.power / drive.speed;  // [N m]
  return loads_of(set, geometry,
                  {speed * ratios.speed.sun, speed * ratios.speed.ring, speed * ratios.speed.carrier,
                   speed * ratios.speed.planet_relative},
                  {torque * ratios.torque.sun, torque * ratios.torque.ring, torque * ratios.torque.carrier});
}

double planet_tangential_load(double carrier_torque, int planets, double centre_distance) {
  assert(planets > 0 && centre_distance > 0.0);
  return std::abs(carrier_torque) / (planets * centre_distance);
}

}  // namespace orbearing::gearset
