// The same scratched bearing with all that moves in it: balls with six freedoms, cage and oil
// (bearing/motion/balls), the outer ring free under its load, the shaft held and turning.
//
// Signs: the load zone's middle is at the angle 0. There the ring is pressed onto the balls, so its load points
// the other way: u of scratched_bearing.hpp is -x of the ring, v is -y.
#pragma once

#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"

namespace orbearing::bearing::defect {

/// Constants of the motion. Mass and freedom of the rings are those of `scratched`: the outer ring is thin, of
/// the radius of its race. Throws std::invalid_argument as ball_numbers(), for more scratches than
/// balls::ScratchNumbers or balls::SpotNumbers hold. A scratch of a ball is round here and its width the diameter,
/// since a ball may turn it out of its track.
balls::BallNumbers scratched_numbers(const ScratchedBearing& scratched, balls::MotionParameters motion);

/// The shaft at its speed or on its way to it, load and weight on the outer ring.
balls::BallDuty scratched_duty(const ScratchedBearing& scratched);

}  // namespace orbearing::bearing::defect
