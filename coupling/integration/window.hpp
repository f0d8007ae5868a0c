// Steps of a controlled stepper that end exactly at the end of a window, with a step size that outlives it.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "mechanics/cancellation.hpp"

namespace orbearing::integration {

/// Limits of the steps in a window.
struct WindowLimits {
  double smallest_step = 1e-13;  // [s]
  long most_steps = 10'000'000;  // [-]  attempts
  double stretch = 1.2;          // [-]  of a step that reaches the end, to spare one short step more
};

/// Thrown if no step was small enough, or the state is not finite.
struct NoStep : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One accepted step of `x` from `time` [s], not beyond the window's `end` [s]. `step` [s] is that to try
/// first and becomes that to try next; where the window's end cuts the step short, it stays. `attempts`
/// counts on. `system` offers what the stepper requires (rosenbrock2.hpp), and
///   begun(x)       after the linearisation at x, from which the step begins
///   stepped(t, h)  after a step of length h from t
///   settle(t, x)   then: puts into x what is known exactly
/// @throws NoStep; std::runtime_error where the attempts are used up; Cancelled
template <class Stepper, class System>
void step_within_window(Stepper& stepper, System& system, std::vector<double>& x, double& time, double end,
                        const WindowLimits& limits, double& step, long& attempts) {
  const auto reason_of = [&](const char* reason) {
    std::ostringstream text;
    text << reason << " at t = " << time << " s of the window to " << end << " s";
    return text.str();
  };
  throw_if_stopped();
  stepper.begin(system, x, time);
  system.begun(x);
  const double before = time;
  bool last = false;
  double attempt = step, reach = limits.stretch;
  while (true) {
    if (++attempts > limits.most_steps)
      throw std::runtime_error(reason_of("the largest number of steps was taken"));
    if (!(step >= limits.smallest_step))
      throw NoStep(reason_of("no step was small enough, or the state is not finite,"));
    last = before + reach * step >= end - limits.smallest_step;
    attempt = last ? end - before : step;
    if (stepper.try_step(system, x, time, attempt) == boost::numeric::odeint::success) break;
    step = attempt;
    reach = 1.0;  // or the same step would be tried for ever
  }
  const double taken = last ? end - before : time - before;
  if (last) time = end;
  system.stepped(before, taken);
  step = last ? std::max(step, attempt) : attempt;
  system.settle(time, x);
}

/// Advances `x` from the beginning of a window to its end, `length` [s] later, by steps as above.
template <class Stepper, class System>
void through_window(Stepper& stepper, System& system, std::vector<double>& x, double length,
                    const WindowLimits& limits, double& step) {
  long attempts = 0;
  for (double time = 0.0; time < length;)
    step_within_window(stepper, system, x, time, length, limits, step, attempts);
}

}  // namespace orbearing::integration
