// The setup of a driven gear set as a table of fields.
#pragma once

#include "coupling/cosim/driven_gears.hpp"
#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/setup_field.hpp"

namespace orbearing::fmu {

/// A gear set and the forces on its planets with which an FMU of it starts.
struct GearModel {
  cosim::DrivenGearsSetup setup;
  std::vector<double> start_force;  // [N], [N], [N m]  (planets)  outward, tangential, moment
};

/// All that a gear set's future depends on beside its inputs, in a fixed order.
std::vector<SetupField<GearModel>> gear_fields();

NumberTable numbers_of(const GearModel& model);

/// Throws std::invalid_argument where a number is missing or makes no sense.
GearModel gears_from(const NumberTable& numbers);

}  // namespace orbearing::fmu
