// Scratches on races and rollers of a bearing of cylindrical rollers in motion (bearing/motion).
#pragma once

#include <vector>

#include "bearing/defect/scratch.hpp"
#include "bearing/motion/model.hpp"

namespace orbearing::bearing::defect {

/// Puts `scratches`, which reach across the whole roller, on `model`. Their angles count in the axes of the motion,
/// from x towards y, when races and rollers have turned by nothing; those of a roller from its own x. A race
/// carries its scratches round as it turns, a roller likewise: how far it has turned becomes a variable of the state.
/// Throws std::invalid_argument for a scratched ball, a roller that is not there, a width or depth that is not
/// positive, a scratch as printed, which jumps, and for more than two scratched rollers.
void put_scratches(const std::vector<Scratch>& scratches, motion::BearingModel& model);

}  // namespace orbearing::bearing::defect
