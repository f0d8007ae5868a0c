#include "app/study/scratch_case.hpp"

#include "app/case/described_case.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/study/planetary_case.hpp"

namespace orbearing::app {

bool is_defect(const ResolvedCase& resolved) {
  return (resolved.model() & model_sets::single_scratched) != 0;
}

analysis::ScratchedVibration scratched_vibration(const ResolvedCase& in, MovingParts moving,
                                                 const analysis::Disturb& disturb) {
  return result_for(in, [&] {
    if (in.model() == roller_defect)
      return analysis::vibration_of_ring(machine_of<analysis::RingOnRollers>(in).of, disturb);
    if (moving == MovingParts::ring)
      return analysis::vibration_of_ring(machine_of<analysis::RingOnBalls>(in).of, disturb);
    require_inputs<machine_rows::ScratchedBallsInMotion>(in);
    return analysis::vibration_in_motion(machine_of<analysis::ScratchedBallsInMotion>(in), {}, disturb);
  });
}

analysis::ScratchedSet scratched_set_of(const ResolvedCase& in) {
  return {.drivetrain = scratched_drivetrain_of(in),
          .scratch = from_case<bearing::defect::Scratch>(in),
          .position = from_case<analysis::ScratchedPosition>(in),
          .sampling = from_case<analysis::PlanetSampling>(in),
          .band = machine_of<analysis::EnvelopeBand>(in)};
}

}  // namespace orbearing::app
