// The setup of a driven bearing as a table of fields.
#pragma once

#include "coupling/cosim/driven_bearing.hpp"
#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/setup_field.hpp"

namespace orbearing::fmu {

/// A bearing and the speeds at which an FMU of it starts.
struct BearingModel {
  cosim::DrivenBearingSetup setup;
  double planet_speed = 0.0;   // [rad/s]  of the bore relative to the carrier
  double carrier_speed = 0.0;  // [rad/s]
};

/// Those of races, drag, support and inertia, and those of the cage's motion: parts of bearing_fields().
void add_race_fields(FieldList<BearingModel>& fields);
void add_cage_motion_fields(FieldList<BearingModel>& fields);

/// All that a bearing's future depends on beside its inputs, in a fixed order.
std::vector<SetupField<BearingModel>> bearing_fields();

NumberTable numbers_of(const BearingModel& model);

/// Throws std::invalid_argument where a number is missing or makes no sense.
BearingModel bearing_from(const NumberTable& numbers);

}  // namespace orbearing::fmu
