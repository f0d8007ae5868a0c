#include "coupling/analysis/drivetrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bearing/carrier_frame.hpp"
#include "bearing/equilibrium/inclined_rows.hpp"
#include "bearing/friction/oil_supply.hpp"
#include "bearing/life/inclined_rating.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

// With a stepped planet, ratio of the gear with the thinner rim: its bearings may be beneath either.
double rim_over_module(const PlanetaryDrivetrain& drivetrain, const gearset::WorkingGeometry& gears) {
  const double bore = 0.5 * drivetrain.bearing.outer.seat_diameter;
  if (!(bore > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const double module = drivetrain.set.module, first = (gears.planet.root_radius - bore) / module;
  if (!gears.second) return first;
  return std::min(first, (gears.second->root_radius - bore) / drivetrain.set.stepped.module.value_or(module));
}

DrivetrainGeometry derive_rigid(const PlanetaryDrivetrain& drivetrain) {
  DrivetrainGeometry geometry;
  geometry.gears = drivetrain.of_pair ? gearset::geometry_of_planet(drivetrain.set, *drivetrain.of_pair)
                                      : gearset::working_geometry(drivetrain.set);
  geometry.planet_gear = gearset::planet_body(drivetrain.set, geometry.gears);
  geometry.bearing = bearing::geometry_of(drivetrain.bearing, drivetrain.rows);
  geometry.planet_mass =
      geometry.planet_gear.mass + drivetrain.bearings_per_planet * geometry.bearing.outer_ring_mass;
  geometry.rim_over_module = rim_over_module(drivetrain, geometry.gears);
  return geometry;
}

gearset::rim::RimInfluence rim_of(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  const gearset::rim::RimSection section =
      gearset::rim::rim_section(drivetrain.set, geometry.gears, geometry.bearing.outer_radius,
                                drivetrain.bearings_per_planet * drivetrain.bearing.width);
  return gearset::rim::rim_influence(section, geometry.gears, drivetrain.bearing.material);
}

}  // namespace

DrivetrainGeometry derive(const PlanetaryDrivetrain& drivetrain) {
  DrivetrainGeometry geometry = derive_rigid(drivetrain);
  geometry.rating =
      bearing::rating::planet_bearing_rating(drivetrain.bearing, drivetrain.rows, drivetrain.rated.stated);
  if (drivetrain.rim == PlanetRim::elastic)
    geometry.rim = std::make_shared<const gearset::rim::RimInfluence>(rim_of(drivetrain, geometry));
  return geometry;
}

gearset::dynamics::Operation set_operation(const PlanetaryDrivetrain& drivetrain,
                                           const gearset::WorkingGeometry& gears) {
  if (!drivetrain.in_arrangement) return gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive);
  const gearset::MeanLoads loads =
      gearset::mean_loads(drivetrain.set, gears, *drivetrain.in_arrangement, drivetrain.drive);
  return {.driven = gearset::Member::sun,
          .speeds = {loads.sun_speed, loads.ring_speed, loads.carrier_speed, loads.planet_speed_relative},
          .torques = {loads.sun_torque, loads.ring_torque, loads.carrier_torque},
          .mesh_frequency =
              drivetrain.set.sun_teeth * std::abs(loads.sun_speed - loads.carrier_speed) / constants::two_pi};
}

bearing::ClearanceChain clearance_chain(const PlanetaryDrivetrain& drivetrain) {
  using constants::pi;
  const DrivetrainGeometry geometry = derive_rigid(drivetrain);
  const gearset::MeanLoads gears = bearing_duty(drivetrain, geometry).gears;
  const double root = geometry.gears.planet.root_radius, bore = 0.5 * drivetrain.bearing.outer.seat_diameter;
  const double density = drivetrain.set.density, width = drivetrain.set.face_width;
  // Teeth: what the body weighs beyond its root circle, at the radius of their inertia.
  const double mass =
      geometry.planet_gear.mass / width - pi * density * (std::pow(root, 2) - std::pow(bore, 2));
  const double inertia =
      geometry.planet_gear.inertia / width - 0.5 * pi * density * (std::pow(root, 4) - std::pow(bore, 4));
  const bool teeth = mass > 0.0 && inertia > 0.0;
  return bearing::clearance_chain(drivetrain.bearing, drivetrain.mounting,
                                  {.planet_outer_radius = root,
                                   .hanging_mass = teeth ? mass : 0.0,
                                   .hanging_radius = teeth ? std::sqrt(inertia / mass) : 0.0,
                                   .planet_speed = gears.carrier_speed + gears.planet_speed_relative,
                                   .pin_speed = gears.carrier_speed});
}

void mount(PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.mounting.state == bearing::ClearanceState::operating) return;
  drivetrain.bearing.radial_clearance = drivetrain.mounting.unmounted_clearance;
  drivetrain.bearing.radial_clearance = clearance_chain(drivetrain).operating;
}

void turn_at(double speed, PlanetaryDrivetrain& drivetrain, DrivetrainGeometry& geometry) {
  drivetrain.drive.speed = speed;
  if (drivetrain.mounting.state == bearing::ClearanceState::operating) return;
  mount(drivetrain);
  geometry = derive(drivetrain);
}

bearing::QuasiStaticOptions quasi_static_options(const PlanetaryDrivetrain& drivetrain) {
  const bearing::motion::DynamicsParameters& dynamics = drivetrain.dynamics;
  bearing::QuasiStaticOptions options{.inertia = dynamics.inertia,
                                      .cage_positions = drivetrain.cage_positions};
  if (dynamics.race.film_in_approach) options.film = dynamics.lubricant;
  return options;
}

bearing::motion::DynamicsParameters bearing_dynamics(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry) {
  bearing::motion::DynamicsParameters parameters = drivetrain.dynamics;
  parameters.bore_mass = geometry.planet_mass / drivetrain.bearings_per_planet;
  parameters.gravity.planet_mass = parameters.bore_mass;
  if (parameters.race.starvation == bearing::motion::Starvation::none ||
      drivetrain.run_up.acceleration != 0.0)  // at speeds that grow
    return parameters;
  return bearing::friction::supplied(drivetrain.bearing, parameters,
                                     bearing_duty(drivetrain, geometry).gears.planet_speed_relative);
}

bearing::motion::DynamicsParameters bearing_dynamics_of(const BearingDuty& duty,
                                                        const PlanetaryDrivetrain& drivetrain,
                                                        const DrivetrainGeometry& geometry) {
  bearing::motion::DynamicsParameters parameters = bearing_dynamics(drivetrain, geometry);
  if (parameters.gravity.acts())
    parameters.gravity.angle =
        gearset::angles_of_planets(drivetrain.set)[static_cast<std::size_t>(duty.planet)];
  return parameters;
}

Eigen::Vector2d bore_tilt(const Misalignment& misalignment, const Eigen::Vector2d& load) {
  return misalignment.planet_tilt.value_or(0.0) * load.normalized() +
         misalignment.carrier_wind_up.value_or(0.0) * Eigen::Vector2d::UnitY();
}

// Masses of a ring that bends without stretching, whose tangential displacement is 1/n of the radial one;
// with wave 0 the whole ring moves outward. Eq. (17) of bearing/motion/README.md.
Eigen::ArrayXd wave_masses(double ring_mass, Eigen::Index orders) {
  Eigen::ArrayXd mass = Eigen::ArrayXd::Constant(orders, ring_mass);
  for (Eigen::Index n = 1; n < orders; ++n) mass[n] *= 0.5 * (1.0 + 1.0 / static_cast<double>(n * n));
  return mass;
}

// A planet that holds the carrier back is the mirror image of one that pulls it on.
bearing::ElasticRace outer_race(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                const gearset::MeanLoads& gears) {
  if (!geometry.rim) return {};
  const gearset::rim::RimInfluence& rim = *geometry.rim;
  const double sense = gears.tangential_force < 0.0 ? -1.0 : 1.0;
  return {.compliance = drivetrain.bearings_per_planet * rim.race,
          .cosine = gears.normal_force * (rim.by_sun.cosine + rim.by_ring.cosine),
          .sine = sense * gears.normal_force * (rim.by_sun.sine + rim.by_ring.sine),
          .mass = wave_masses(geometry.planet_mass / drivetrain.bearings_per_planet, rim.race.size())};
}

namespace {

gearset::MeanLoads gear_loads(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  if (drivetrain.of_pair)
    return gearset::mean_loads_of_planet(drivetrain.set, *drivetrain.of_pair, *drivetrain.in_arrangement,
                                         drivetrain.drive);
  if (drivetrain.in_arrangement)
    return gearset::mean_loads(drivetrain.set, geometry.gears, *drivetrain.in_arrangement, drivetrain.drive);
  return gearset::mean_loads(drivetrain.set, geometry.gears, drivetrain.drive);
}

}  // namespace

BearingDuty bearing_duty(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  BearingDuty duty;
  duty.gears = gear_loads(drivetrain, geometry);
  duty.point.carrier = {.speed = duty.gears.carrier_speed, .orbit_radius = geometry.gears.centre_distance};
  duty.point.outer_speed = duty.gears.planet_speed_relative;
  const bearing::CarrierFrame frame = bearing::carrier_frame(duty.point.carrier, drivetrain.dynamics.inertia);
  const Eigen::Vector2d meshes(duty.gears.radial_force, duty.gears.tangential_force);
  const Eigen::Vector2d acceleration =
      bearing::inertial_acceleration(frame, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  const Eigen::Vector2d inertia = geometry.planet_mass * acceleration;
  duty.couple = Eigen::Vector2d(duty.gears.couple_outward, duty.gears.couple_ahead) +
                geometry.planet_gear.first_moment * acceleration;
  duty.point.bore_load = (meshes + inertia) / drivetrain.bearings_per_planet;
  duty.point.bore_tilt = bore_tilt(drivetrain.misalignment, duty.point.bore_load);
  duty.point.outer_race = outer_race(drivetrain, geometry, duty.gears);
  return duty;
}

}  // namespace orbearing::analysis
