#include "app/study/fmu_model.hpp"

#include "app/errors.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/fmu/model.hpp"
#include "coupling/study/driven_setups.hpp"
#include "coupling/system/driven_bearing.hpp"

namespace orbearing::app {

namespace {

void require(bool good, const ResolvedCase& in, const std::string& key, const std::string& found,
             const std::string& required) {
  if (!good) throw BadInput(in.file() + ": " + key + ": found " + found + "; required: " + required);
}

void require_drivable_set(const ResolvedCase& in) {
  require(in.model() == planetary_drivetrain, in, "model", in.choice("model"),
          "planetary-drivetrain, whose parts can be driven");
  require(!in.shape().several, in, "sets", "several sets", "one set, as gearset at the top of a case");
}

system::DrivenBearingSetup bearing_setup(const ResolvedCase& in) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(in);
  const study::DrivetrainGeometry geometry = study::derive(drivetrain);
  const study::BearingDuty duty = study::bearing_duty(drivetrain, geometry);
  system::DrivenBearingSetup setup = study::driven_bearing_setup(drivetrain, geometry);
  setup.planet_speed = duty.point.outer_speed;
  setup.carrier_speed = duty.point.carrier.speed;
  setup.start_load = duty.point.bore_load;
  return setup;
}

// Gears without roller bearings have no drivetrain that could be computed as a whole.
system::DrivenGearsSetup gears_setup(const ResolvedCase& in) {
  const gearset::dynamics::SetModel set = moving_gears_of(in);
  if (in.shape().bearing) {
    system::DrivenGearsSetup setup = study::driven_gears_setup(drivetrain_of(in));
    setup.operation.run_up = set.operation.run_up;
    return setup;
  }
  system::DrivenGearsSetup setup{.set = set.parameters, .operation = set.operation};
  setup.set.planet.coupled_bearing = true;
  return setup;
}

// The forces that linear bearings give in the static state, so that an unconnected set begins at rest.
std::vector<double> start_forces(const system::DrivenGearsSetup& setup) {
  system::DrivenGears gears(setup);
  gears.initialize(0.0);
  std::vector<double> forces;
  for (const system::PlanetMotion& planet : gears.output().planets) {
    const Eigen::Vector2d force = -setup.set.planet.bearing_stiffness * planet.displacement;
    forces.insert(forces.end(), {force.x(), force.y(), 0.0});
  }
  return forces;
}

}  // namespace

fmu::NumberTable bearing_numbers(const ResolvedCase& in) {
  require_drivable_set(in);
  require(in.shape().bearing, in, "bearing", "no bearing", "a planet bearing, or --model gearset");
  system::DrivenBearingSetup setup = bearing_setup(in);
  try {
    const system::DrivenBearing driven(setup);
    setup.start_displacement = driven.position_under(
        setup.start_load, {.speed = setup.planet_speed, .carrier_speed = setup.carrier_speed});
  } catch (const std::invalid_argument& unfit) {
    throw BadInput(in.file() + ": " + unfit.what());
  }
  return fmu::numbers_of(setup);
}

fmu::NumberTable gear_numbers(const ResolvedCase& in) {
  require_drivable_set(in);
  require(in.shape().teeth, in, "gearset", "no teeth", "tooth numbers, from which loads and speeds follow");
  system::DrivenGearsSetup setup = gears_setup(in);
  setup.start_force = start_forces(setup);
  return fmu::numbers_of(setup);
}

}  // namespace orbearing::app
