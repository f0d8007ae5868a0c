#include "coupling/integration/integrate.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "coupling/integration/dopri5.hpp"

namespace orbearing::integration {

namespace {

using namespace detail;

bool run_dense(System system, Eigen::VectorXd& x, const OutputTimes& output,
               const IntegrationOptions& options, const Observer& observe, Run& run) {
  DenseDopri5 stepper{ControlledDopri5(WeightedError(options))};
  State start(x.data(), x.data() + x.size());
  State sample(start);
  stepper.initialize(start, output.time(0), options.step);
  for (long i = 1; i <= output.samples; ++i) {
    while (stepper.current_time() < output.time(i)) {
      try {
        stepper.do_step(system);
      } catch (const odeint::odeint_error&) {
        return run.fail("no step was small enough, or the state is not finite,");
      }
      x = view(stepper.current_state());
      if (!run.accept(stepper.current_time(), stepper.current_time() - stepper.previous_time())) return false;
    }
    stepper.calc_state(output.time(i), sample);
    if (observe) observe(output.time(i), view(sample));
  }
  x = view(sample);
  return true;
}

template <class Stepper>
bool run_fixed(System system, Eigen::VectorXd& x, const OutputTimes& output,
               const IntegrationOptions& options, const Observer& observe, Run& run) {
  Stepper stepper;
  State state(x.data(), x.data() + x.size());
  const long steps = std::max(1L, std::lround(std::ceil(output.interval / options.step * (1.0 - 1e-12))));
  const double step = output.interval / static_cast<double>(steps);
  for (long i = 0; i < output.samples; ++i) {
    for (long k = 0; k < steps; ++k) {
      const double time = output.time(i) + static_cast<double>(k) * step;
      stepper.do_step(system, state, time, step);
      if (!run.accept(time + step, step)) return false;
    }
    if (!view(state).allFinite()) return run.fail("the state is not finite");
    x = view(state);
    if (observe) observe(output.time(i + 1), view(state));
  }
  return true;
}

}  // namespace

void append(const IntegrationReport& part, IntegrationReport& all) {
  all.smallest_step = all.steps == 0 ? part.smallest_step : std::min(all.smallest_step, part.smallest_step);
  all.steps += part.steps;
  all.rejected += part.rejected;
  all.rhs_calls += part.rhs_calls;
  all.wall_seconds += part.wall_seconds;
  all.next_step = part.next_step;
  all.reached = part.reached;
  all.completed = part.completed;
  all.message = part.message;
}

IntegrationReport integrate(const RightHandSide& derivative, Eigen::VectorXd& x, const OutputTimes& output,
                            const IntegrationOptions& options, const Observer& observe) {
  const long starts = options.method == Method::dopri5 ? 1 : 0;
  return reported(derivative, x, output, options, starts, [&](System system, Run& run, IntegrationReport&) {
    switch (options.method) {
      case Method::dopri5:
        return run_dense(system, x, output, options, observe, run);
      case Method::fixed_dopri5:
        return run_fixed<Dopri5>(system, x, output, options, observe, run);
      case Method::rk4:
        return run_fixed<odeint::runge_kutta4<State>>(system, x, output, options, observe, run);
      case Method::linearly_implicit:
        break;
    }
    throw std::invalid_argument("linearly implicit steps need a Jacobian: system::integrate_bearing()");
  });
}

}  // namespace orbearing::integration
