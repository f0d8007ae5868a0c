#include "coupling/analysis/drivetrain_physics.hpp"

#include "mechanics/member_keys.hpp"

namespace orbearing::analysis {

namespace {

using PhysicsByKey = std::map<std::string, Physics, std::less<>>;

PhysicsByKey found_physics() {
  const DrivetrainRows rows;
  const mechanics::MemberKeys key(rows);
  const PlanetaryDrivetrain& planets = rows.set.planets;
  const gearset::PlanetarySet& teeth = rows.set.teeth;
  const GearDynamicsChoice& gears = rows.set.gears.choice;
  const bearing::Bearing& bearing = planets.bearing;
  const bearing::PlanetRows& planet_rows = planets.rows;
  const bearing::CylindricalRollers& rollers = bearing.rollers();
  const bearing::motion::DynamicsParameters& dynamics = planets.dynamics;
  const bearing::InertiaSwitches& inertia = dynamics.inertia;
  const system::SteadyStateOptions& steady = planets.steady_state;

  PhysicsByKey physics;  // of parts first, then of single members in them
  const auto put = [&](Physics one, const auto&... members) {
    for (const std::string& path : key.of(members...)) physics[path] = one;
  };
  using enum Physics;
  put(everywhere, rows.set.gears.material, rows.set.profile);
  put(planet, rows.drive.member, rows.drive.speed, rows.drive.speed_of, rows.drive.parallel.front,
      bearing.outer.seat_diameter, rows.set.second_planet, teeth);
  put(thrust, teeth.sun_thrust);
  put(central_teeth, teeth.sun_heights, teeth.ring_heights, teeth.web, teeth.flanks);
  put(positions, teeth.planet_angles);
  put(output, rows.drive.parallel.behind);
  put(gear_bodies, gears.sun, gears.ring, gears.carrier, gears.planet, gears.bearing_stiffness,
      gears.sun_mesh_stiffness, gears.ring_mesh_stiffness);
  put(gear_motion, gears.mesh_damping_ratio, gears.bearing_damping_ratio, gears.support_damping_ratio,
      gears.backlash, gears.separation, gears.sun_error, gears.ring_error, planets.mesh_variation);
  put(load_sharing, gears.pin_error_radial, gears.pin_error_tangential);
  put(walls, gears.carrier_plate_ratio);
  put(carrier_body, rows.set.carrier);
  put(balance, planet_rows.balls, planet_rows.ball_diameter, planets.mounting, bearing.pitch_diameter,
      bearing.radial_clearance, rollers.count, rollers.diameter, rollers.length, bearing.contact_law);
  put(motion, dynamics.race, dynamics.cage, dynamics.neighbours, dynamics.drag, rollers.diameter_deviation,
      dynamics.support.damping_ratio, steady.integration.method, steady.allowed_length_error,
      steady.load_error_share);
  put(carrier, rows.drive.power, rows.drive.application_factor, bearing.cage, planets.bearings_per_planet,
      bearing.width, dynamics.race.film_in_approach, planets.rim, inertia.coriolis,
      inertia.carrier_centrifugal, inertia.own_orbit, dynamics.lubricant, bearing.material.density);
  put(pin, bearing.inner.seat_diameter, dynamics.support.stiffness);
  put(at_rest, planets.seats, planet_rows.contact_angle, planet_rows.arrangement, planet_rows.distance,
      planet_rows.preload, planet_rows.approach, planets.cage_positions);
  put(euler, inertia.euler);
  put(life, rollers.laminae, planets.misalignment, planets.reduction_factor);
  put(run, dynamics.gravity, steady.observed_windows, steady.most_windows, steady.load_drift,
      steady.cage_drift);
  put(run_up, planets.run_up);
  put(defect, rows.scratch, rows.position, rows.sampling);
  put(exchange, planets.exchange);
  return physics;
}

}  // namespace

const PhysicsByKey& physics_of_inputs() {
  static const PhysicsByKey physics = found_physics();
  return physics;
}

}  // namespace orbearing::analysis
