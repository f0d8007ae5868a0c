#include "app/case/static_case.hpp"

#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

bool is_static_bearing(const ResolvedCase& resolved) {
  return resolved.model() == roller_bearing || resolved.model() == ball_bearing;
}

bool is_ball_run(const ResolvedCase& resolved) {
  return resolved.model() == ball_motion;
}

analysis::BearingUnderLoad bearing_under_load(const ResolvedCase& in) {
  if (!is_static_bearing(in))
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: roller-bearing or ball-bearing");
  return result_for(in, [&] {
    return in.model() == roller_bearing
               ? analysis::rollers_under_load(machine_of<analysis::RollersUnderLoad>(in))
               : analysis::balls_under_load(machine_of<analysis::BallsUnderLoad>(in));
  });
}

analysis::BallRun ball_run(const ResolvedCase& in, const std::function<void(double)>& progress) {
  return result_for(in,
                    [&] { return analysis::run_of_balls(machine_of<analysis::BallsInTime>(in), progress); });
}

}  // namespace orbearing::app
