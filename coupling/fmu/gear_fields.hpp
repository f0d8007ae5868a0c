// The setup of a driven gear set as a table of fields.
#pragma once

#include "coupling/cosim/driven_gears.hpp"
#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/setup_field.hpp"

namespace orbearing::fmu {

/// All that a gear set's future depends on beside its inputs, in a fixed order.
std::vector<SetupField<cosim::DrivenGearsSetup>> gear_fields();

NumberTable numbers_of(const cosim::DrivenGearsSetup& setup);

/// Throws std::invalid_argument where a number is missing or makes no sense.
cosim::DrivenGearsSetup gears_from(const NumberTable& numbers);

}  // namespace orbearing::fmu
