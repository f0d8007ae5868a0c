#include "coupling/study/set_operation.hpp"

#include <cmath>

#include "mechanics/constants.hpp"

namespace orbearing::study {

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

}  // namespace orbearing::study
