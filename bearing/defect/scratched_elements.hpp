// Scratches on races and rollers of a bearing of cylindrical rollers in motion (bearing/motion).
#pragma once

#include <vector>

#include "bearing/defect/scratch.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "bearing/motion/model.hpp"

namespace orbearing::bearing::defect {

// The same scratched bearing with all that moves in it: balls with six freedoms, cage and oil
// (bearing/motion/balls), the outer ring free under its load, the shaft held and turning.
//
// Signs: the load zone's middle is at the angle 0. There the ring is pressed onto the balls, so its load
// points the other way: u of scratched_bearing.hpp is -x of the ring, v is -y.

/// Constants of the motion. Mass and freedom of the rings are those of `scratched`: the outer ring is thin,
/// of the radius of its race. Throws std::invalid_argument as ball_numbers(), for more scratches than
/// balls::ScratchNumbers or balls::SpotNumbers hold. A scratch of a ball is round here and its width the
/// diameter, since a ball may turn it out of its track.
balls::BallNumbers scratched_numbers(const ScratchedBearing& scratched, balls::MotionParameters motion);

/// The shaft at its speed or on its way to it, load and weight on the outer ring.
balls::BallDuty scratched_duty(const ScratchedBearing& scratched);

/// Puts `scratches`, which reach across the whole roller, on `model`. Their angles count in the axes of the
/// motion, from x towards y, when races and rollers have turned by nothing; those of a roller from its own x.
/// A race carries its scratches round as it turns, a roller likewise: how far it has turned becomes a
/// variable of the state. Throws std::invalid_argument for a scratched ball, a roller that is not there, a
/// width or depth that is not positive, a scratch as printed, which jumps, and for more than two scratched
/// rollers.
void put_scratches(const std::vector<Scratch>& scratches, motion::BearingModel& model);

}  // namespace orbearing::bearing::defect
