// Integration of ordinary differential equations x' = f(t, x): the only file in which an integrator runs.
#pragma once

#include "coupling/integration/integration_options.hpp"

namespace orbearing::integration {

/// Adds to `all` the part of a run that follows it.
void append(const IntegrationReport& part, IntegrationReport& all);

/// Integrates from `x` at the first output time to the last and leaves the final state in `x`. `observe` is
/// called after each interval, not at the start; it may be empty. A state that is no longer finite, a step
/// too small and an exhausted budget end the run with a message; `x` is then the last good state.
IntegrationReport integrate(const RightHandSide& derivative, Eigen::VectorXd& x, const OutputTimes& output,
                            const IntegrationOptions& options, const Observer& observe);

}  // namespace orbearing::integration
