// From a resolved case of the model gear-pair to the parameters of the pair.
#pragma once

#include "app/case/resolved_case.hpp"
#include "gearset/gear_pair.hpp"

namespace orbearing::app {

/// Lists must hold two values each.
gearset::GearPair pair_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
