#include "coupling/cosim/planetary_coupling.hpp"

#include <boost/math/constants/constants.hpp>
#include <stdexcept>

#include "coupling/study/driven_setups.hpp"

namespace orbearing::cosim {

namespace {

using boost::math::double_constants::two_pi;

void require_alone(const study::PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.in_arrangement)
    throw std::invalid_argument("drivetrain: found one of several sets; required: a set alone");
}

std::string bearing_name(int planet, int bearing) {
  return "planet_" + std::to_string(planet + 1) + ".bearing_" + std::to_string(bearing + 1);
}

}  // namespace

Participants PlanetaryCoupling::participants() const {
  Participants out{gears.get()};
  for (const std::unique_ptr<BearingParticipant>& bearing : bearings) out.push_back(bearing.get());
  return out;
}

// A run-up starts at the speed of the drive, while the gear set counts from the speed at its end.
gearset::dynamics::Operation operation_of(const study::PlanetaryDrivetrain& drivetrain) {
  gearset::Drive drive = drivetrain.drive;
  const study::RunUp& run_up = drivetrain.run_up;
  const bool speeds_up = run_up.acceleration != 0.0 && run_up.duration > 0.0;
  if (speeds_up) drive.speed += run_up.acceleration * run_up.duration;
  gearset::dynamics::Operation operation = gearset::dynamics::operation_of(drivetrain.set, drive);
  if (speeds_up) operation.run_up = {drivetrain.drive.speed / drive.speed, run_up.duration};
  return operation;
}

DrivenGearsSetup gears_setup(const study::PlanetaryDrivetrain& drivetrain,
                             const PlanetaryCouplingOptions& options) {
  require_alone(drivetrain);
  DrivenGearsSetup setup = study::driven_gears_setup(drivetrain);
  setup.operation = operation_of(drivetrain);
  setup.allowed_share = options.allowed_share;
  setup.set.planet.coupled_bearing = !options.gears_on_springs;
  return setup;
}

DrivenBearingSetup bearing_setup(const study::PlanetaryDrivetrain& drivetrain,
                                 const study::DrivetrainGeometry& geometry, int bearing_of_planet,
                                 const PlanetaryCouplingOptions& options) {
  DrivenBearingSetup setup = study::driven_bearing_setup(drivetrain, geometry);
  setup.allowed_length_error = options.allowed_length_error;
  setup.first_roller +=
      two_pi * bearing_of_planet / (drivetrain.bearing.rollers * drivetrain.bearings_per_planet);
  return setup;
}

PlanetaryCoupling planetary_coupling(const study::PlanetaryDrivetrain& drivetrain,
                                     const study::DrivetrainGeometry& geometry,
                                     const PlanetaryCouplingOptions& options) {
  const DrivenGearsSetup gears = gears_setup(drivetrain, options);
  PlanetaryCoupling out;
  out.gears = std::make_unique<GearsParticipant>(gears);
  for (int planet = 0; planet < drivetrain.set.planets; ++planet)
    for (int bearing = 0; bearing < drivetrain.bearings_per_planet; ++bearing)
      out.bearings.push_back(std::make_unique<BearingParticipant>(
          bearing_setup(drivetrain, geometry, bearing, options),
          BearingPlace{bearing_name(planet, bearing), planet, gears.operation}));
  return out;
}

}  // namespace orbearing::cosim
