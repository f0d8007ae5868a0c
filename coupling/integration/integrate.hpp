// Integration of ordinary differential equations x' = f(t, x): the one place where an integrator runs.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "coupling/integration/integration_options.hpp"

namespace orbearing::integration {

/// Sees the state at each output time.
using Observer = std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& x)>;

/// Adds to `all` the part of a run that follows it.
void append(const IntegrationReport& part, IntegrationReport& all);

/// Output times start, start + interval, ..., `samples` intervals in all, after the first `passed` ones.
struct OutputTimes {
  double start = 0.0;     // [s]
  double interval = 0.0;  // [s]
  long samples = 0;       // [-]
  long passed = 0;        // [-]  so that runs in turn keep to multiples of one interval

  double time(long sample) const { return start + static_cast<double>(passed + sample) * interval; }
};

/// Integrates from `x` at the first output time to the last and leaves the final state in `x`. `observe` is
/// called after each interval, not at the start; it may be empty. A state that is no longer finite, a step
/// too small and an exhausted budget end the run with a message; `x` is then the last good state.
IntegrationReport integrate(const RightHandSide& derivative, Eigen::VectorXd& x, const OutputTimes& output,
                            const IntegrationOptions& options, const Observer& observe);

}  // namespace orbearing::integration
