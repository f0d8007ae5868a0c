#include "app/case/static_case.hpp"

#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

namespace {

// The result of an analysis; its failure with the name of the case.
template <class Analyse>
auto result_of(const ResolvedCase& in, const Analyse& analyse) {
  try {
    return analyse();
  } catch (const analysis::NoResult& error) {
    throw ComputationFailed(in.text("name") + ": " + error.what());
  }
}

}  // namespace

bool is_static_bearing(const ResolvedCase& resolved) {
  return resolved.model() == roller_bearing || resolved.model() == ball_bearing;
}

bool is_ball_run(const ResolvedCase& resolved) {
  return resolved.model() == described::ball_motion;
}

analysis::BearingUnderLoad bearing_under_load(const ResolvedCase& in) {
  if (!is_static_bearing(in))
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: roller-bearing or ball-bearing");
  return result_of(in, [&] {
    return in.model() == roller_bearing
               ? analysis::rollers_under_load(machine_of<analysis::RollersUnderLoad>(in))
               : analysis::balls_under_load(machine_of<analysis::BallsUnderLoad>(in));
  });
}

analysis::BallRun ball_run(const ResolvedCase& in, const std::function<void(double)>& progress) {
  return result_of(in,
                   [&] { return analysis::run_of_balls(machine_of<analysis::BallsInTime>(in), progress); });
}

std::vector<Derived> static_quantities(const ResolvedCase& in) {
  described::Record record;
  describe(record, in.model() == roller_bearing ? quantities_of(machine_of<analysis::RollersUnderLoad>(in))
                                                : quantities_of(machine_of<analysis::BallsUnderLoad>(in)));
  return derived_rows(record);
}

}  // namespace orbearing::app
