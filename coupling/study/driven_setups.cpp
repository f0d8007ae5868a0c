#include "coupling/study/driven_setups.hpp"

#include <stdexcept>

#include "coupling/study/load_sharing.hpp"
#include "gearset/dynamics/model.hpp"

namespace orbearing::study {

system::DrivenBearingSetup driven_bearing_setup(const PlanetaryDrivetrain& drivetrain,
                                                const DrivetrainGeometry& geometry) {
  const bearing::OperatingPoint point = bearing_duty(drivetrain, geometry).point;
  return {.bearing = drivetrain.bearing,
          .dynamics = bearing_dynamics(drivetrain, geometry),
          .orbit_radius = geometry.gears.centre_distance,
          .first_roller = drivetrain.steady_state.first_roller,
          .reduction_factor = drivetrain.reduction_factor,
          .bore_tilt = point.bore_tilt,
          .outer_race = point.outer_race,
          .allowed_length_error = drivetrain.steady_state.allowed_length_error,
          .bins = drivetrain.steady_state.bins};
}

system::DrivenGearsSetup driven_gears_setup(const PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.in_arrangement)
    throw std::invalid_argument("drivetrain: found one of several sets; required: a set alone");
  if (!drivetrain.gear_set)
    throw std::invalid_argument(
        "gears that move: found none; required: one planetary set with teeth or with stated mesh stiffness");
  const gearset::dynamics::Operation operation =
      gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive);
  system::DrivenGearsSetup setup{.set = drivetrain.gear_set(), .operation = operation};
  if (!drivetrain.mesh_variation)
    setup.set = gearset::dynamics::averaged(gearset::dynamics::set_model(setup.set, operation)).parameters;
  setup.set.planet.coupled_bearing = true;
  return setup;
}

system::CoupledSetup coupled_setup(const PlanetaryDrivetrain& drivetrain,
                                   const DrivetrainGeometry& geometry) {
  system::CoupledSetup setup{driven_gears_setup(drivetrain), driven_bearing_setup(drivetrain, geometry),
                             drivetrain.bearings_per_planet};
  const bool tilted = drivetrain.misalignment.planet_tilt != 0.0;
  if (!drivetrain.uneven_planets || !(tilted || geometry.rim)) return setup;
  for (const BearingDuty& duty : planet_duties(drivetrain, geometry)) {
    if (tilted) setup.bore_tilts.push_back(duty.point.bore_tilt);
    if (geometry.rim) setup.outer_races.push_back(duty.point.outer_race);
  }
  return setup;
}

}  // namespace orbearing::study
