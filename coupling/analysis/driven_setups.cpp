#include "coupling/analysis/driven_setups.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "bearing/motion/model.hpp"
#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "gearset/dynamics/model.hpp"

namespace orbearing::analysis {

system::DrivenBearingSetup driven_bearing_setup(const PlanetaryDrivetrain& drivetrain,
                                                const DrivetrainGeometry& geometry) {
  const bearing::OperatingPoint point = bearing_duty(drivetrain, geometry).point;
  bearing::motion::DynamicsParameters dynamics = bearing_dynamics(drivetrain, geometry);
  dynamics.race = bearing::motion::with_limited_scales(geometry.bearing, point, dynamics.race);
  return {.bearing = drivetrain.bearing,
          .dynamics = std::move(dynamics),
          .orbit_radius = geometry.gears.centre_distance,
          .first_roller = drivetrain.steady_state.first_roller,
          .reduction_factor = drivetrain.reduction_factor,
          .bore_tilt = point.bore_tilt,
          .outer_race = point.outer_race,
          .allowed_length_error = drivetrain.steady_state.allowed_length_error,
          .bins = drivetrain.steady_state.bins};
}

namespace {

double speed_of(gearset::Member member, const gearset::Speeds& speeds) {
  if (member == gearset::Member::sun) return speeds.sun;
  return member == gearset::Member::ring ? speeds.ring : speeds.carrier;
}

// Among several sets: the shafts to the others keep their torques, but for the one by which most power
// enters: it keeps that power, as a motor does, and holds the speed.
gearset::dynamics::Operation moving_operation(const PlanetaryDrivetrain& drivetrain) {
  using gearset::Member;
  gearset::dynamics::Operation operation =
      set_operation(drivetrain, gearset::working_geometry(drivetrain.set));
  if (!drivetrain.in_arrangement) return operation;
  constexpr double still = 1e-9;  // [-]  of the planets' speed: what round-off leaves of none
  if (std::abs(speed_of(drivetrain.set.fixed_member, operation.speeds)) >
      still * std::abs(operation.speeds.planet_relative))
    throw std::invalid_argument(
        "drivetrain: found one of several sets, none of whose members the housing holds; required: one that "
        "is "
        "held");
  const gearset::Torques& torque = operation.torques;
  const auto enters_by = [&](Member member, double on_member) {
    const double power = on_member * speed_of(member, operation.speeds);
    if (power <= operation.power) return;
    operation.power = power;
    operation.driven = member;
  };
  enters_by(Member::sun, torque.sun);
  enters_by(Member::ring, torque.ring);
  enters_by(Member::carrier, torque.carrier);
  return operation;
}

}  // namespace

system::DrivenGearsSetup driven_gears_setup(const PlanetaryDrivetrain& drivetrain) {
  if (!drivetrain.gear_set)
    throw std::invalid_argument(
        "gears that move: found none; required: one planetary set with teeth or with stated mesh stiffness");
  const gearset::dynamics::Operation operation = moving_operation(drivetrain);
  system::DrivenGearsSetup setup{.set = drivetrain.gear_set(), .operation = operation};
  if (!drivetrain.mesh_variation)
    setup.set = gearset::dynamics::averaged(gearset::dynamics::set_model(setup.set, operation)).parameters;
  setup.set.planet.coupled_bearing = true;
  setup.set.gravity = drivetrain.dynamics.gravity.across;
  return setup;
}

namespace {

// Seats of all planets: each with its own tilt and form of the race.
std::vector<system::BearingSeat> seats_of_unlike(const PlanetaryDrivetrain& drivetrain,
                                                 const DrivetrainGeometry& geometry) {
  std::vector<system::BearingSeat> seats;
  for (const BearingDuty& duty : planet_duties(drivetrain, geometry))
    seats.insert(seats.end(), static_cast<std::size_t>(drivetrain.bearings_per_planet),
                 {.bore_tilt = duty.point.bore_tilt, .outer_race = duty.point.outer_race});
  return seats;
}

// The same, each on its seat at rest under its own load.
std::vector<system::BearingSeat> seats_of_all(const PlanetaryDrivetrain& drivetrain,
                                              const DrivetrainGeometry& geometry) {
  const std::vector<BearingDuty> duties = planet_duties(drivetrain, geometry);
  const PlanetSeat seat = seat_of_each(drivetrain, geometry);
  std::vector<system::BearingSeat> seats;
  for (const BearingDuty& duty : duties)
    for (const SeatedBearing& one : seated_bearings(seat, drivetrain, geometry, duty))
      seats.push_back({.clearance_difference =
                           one.drivetrain.bearing.radial_clearance - drivetrain.bearing.radial_clearance,
                       .bore_tilt = one.duty.point.bore_tilt,
                       .outer_race = one.duty.point.outer_race,
                       .pin_offset = one.pin_offset});
  const std::size_t found = seats.size();  // of one planet where all carry alike
  const auto all = static_cast<std::size_t>(drivetrain.set.planets * drivetrain.bearings_per_planet);
  for (std::size_t b = found; b < all; ++b) seats.push_back(seats[b % found]);
  return seats;
}

}  // namespace

system::CoupledSetup coupled_setup(const PlanetaryDrivetrain& drivetrain,
                                   const DrivetrainGeometry& geometry) {
  system::CoupledSetup setup{driven_gears_setup(drivetrain), driven_bearing_setup(drivetrain, geometry),
                             drivetrain.bearings_per_planet};
  if (drivetrain.seats.tilt == TiltState::computed)
    setup.seats = seats_of_all(drivetrain, geometry);
  else if (drivetrain.uneven_planets &&
           (drivetrain.misalignment.planet_tilt.value_or(0.0) != 0.0 || geometry.rim))
    setup.seats = seats_of_unlike(drivetrain, geometry);
  return setup;
}

}  // namespace orbearing::analysis
