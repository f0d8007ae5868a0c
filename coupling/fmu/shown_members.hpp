// Members of the setups that an FMU shows: parameters, which may be set before the run, and constants, which
// fix the number of its variables. The others travel with the model, unseen.
#pragma once

#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/driven_gears.hpp"
#include "mechanics/extents.hpp"

namespace orbearing::fmu {

struct ShownMembers {
  mechanics::Extents parameters, constants;
};

/// Numbers among these members alone are shown.
ShownMembers shown_members(const system::DrivenBearingSetup& setup);
ShownMembers shown_members(const system::DrivenGearsSetup& setup);

}  // namespace orbearing::fmu
