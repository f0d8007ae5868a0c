#include "gearset/mean_loads.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>

#include "gearset/stepped_planet.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::gearset {

namespace {

// The second gear turns with the first, whose torque about the planet's axis it takes. Eqs. (42) and (43).
void put_stepped(const PlanetarySet& set, const WorkingGeometry& geometry, double sun_force,
                 MeanLoads& loads) {
  const double ring_force = sun_force * geometry.planet.base_radius / geometry.second->base_radius;
  loads.ring_normal_force = std::abs(ring_force);
  const double sun_angle = geometry.sun_mesh.working_pressure_angle;
  const double ring_angle = geometry.ring_mesh.working_pressure_angle;
  const double sun_outward = loads.normal_force * std::sin(sun_angle),
               sun_ahead = sun_force * std::cos(sun_angle);
  const double ring_outward = -loads.ring_normal_force * std::sin(ring_angle);
  const double ring_ahead = ring_force * std::cos(ring_angle);
  loads.tangential_force = sun_ahead + ring_ahead;
  loads.radial_force = sun_outward + ring_outward;
  const GearPlanes planes = gear_planes(set);
  loads.couple_outward = planes.sun * sun_outward + planes.ring * ring_outward;
  loads.couple_ahead = planes.sun * sun_ahead + planes.ring * ring_ahead;
}

MeanLoads members_of(const Speeds& speeds, const Torques& torques) {
  return {.sun_speed = speeds.sun,
          .ring_speed = speeds.ring,
          .carrier_speed = speeds.carrier,
          .planet_speed_relative = speeds.planet_relative,
          .sun_torque = torques.sun,
          .ring_torque = torques.ring,
          .carrier_torque = torques.carrier};
}

// `loads`: those of the members.
MeanLoads with_forces(const PlanetarySet& set, const WorkingGeometry& geometry, MeanLoads loads) {
  assert(set.planets > 0);
  const double sun_angle = geometry.sun_mesh.working_pressure_angle;
  const double ring_angle = geometry.ring_mesh.working_pressure_angle;

  const double signed_normal_force = loads.sun_torque / (set.planets * geometry.sun.base_radius);
  loads.normal_force = std::abs(signed_normal_force);
  loads.tangential_force = signed_normal_force * (std::cos(sun_angle) + std::cos(ring_angle));
  // Teeth only push: the sun outward and the ring inward, whichever flank carries.
  loads.radial_force = loads.normal_force * (std::sin(sun_angle) - std::sin(ring_angle));
  loads.ring_normal_force = loads.normal_force;
  if (geometry.second) put_stepped(set, geometry, signed_normal_force, loads);
  loads.tooth_force = loads.normal_force / std::cos(geometry.base_helix_angle);
  // The right-handed flank of a sun that pushes on counterclockwise faces down the axis.
  const double thrust = signed_normal_force * std::tan(geometry.base_helix_angle);
  loads.axial_force = 0.0 - thrust;  // spur gears: 0, not -0
  loads.overturning_moment = loads.axial_force * (planet_working_radius(geometry, geometry.sun_mesh) +
                                                  planet_working_radius(geometry, geometry.ring_mesh));
  loads.sun_thrust = 0.0 + set.planets * thrust;
  return loads;
}

}  // namespace

MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const Drive& drive) {
  return with_forces(set, geometry, members_of(member_speeds(set, drive), member_torques(set, drive)));
}

MeanLoads member_loads(const MemberRatios& ratios, const Drive& drive) {
  mechanics::require_positive(drive.motor_speed(), "speed of the motor");
  mechanics::require_positive(drive.power, "power of the motor");
  const double sense = ratios.speed.carrier < 0.0 ? -1.0 : 1.0;
  const double speed = sense * drive.motor_speed();                        // [rad/s]
  const double torque = sense * drive.load_power() / drive.motor_speed();  // [N m]
  return members_of(
      {speed * ratios.speed.sun, speed * ratios.speed.ring, speed * ratios.speed.carrier,
       speed * ratios.speed.planet_relative},
      {torque * ratios.torque.sun, torque * ratios.torque.ring, torque * ratios.torque.carrier});
}

MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const MemberRatios& ratios,
                     const Drive& drive) {
  return with_forces(set, geometry, member_loads(ratios, drive));
}

AxialReactions axial_reactions(const PlanetarySet& set, const MeanLoads& loads) {
  const bool by_carrier = set.sun_thrust == SunThrust::carrier;
  const double held = 0.0 - loads.sun_thrust;
  return {.sun = by_carrier ? 0.0 : held, .carrier = by_carrier ? held : 0.0, .ring = loads.sun_thrust};
}

double planet_tangential_load(double carrier_torque, int planets, double centre_distance) {
  assert(planets > 0 && centre_distance > 0.0);
  return std::abs(carrier_torque) / (planets * centre_distance);
}

}  // namespace orbearing::gearset
