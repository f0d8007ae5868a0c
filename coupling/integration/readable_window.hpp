// Steps of Dormand and Prince that end exactly at the end of a window: for what the vectorised bearing lacks.
#pragma once

#include "coupling/integration/integrate.hpp"
#include "coupling/integration/window.hpp"

namespace orbearing::integration {

/// Sees each accepted step: where it began [s], its length [s] and the state at its beginning.
using StepBegin = std::function<void(double time, double length, const Eigen::Ref<const Eigen::VectorXd>& x)>;

/// As through_window(), for x' = f(t, x) by dopri5 with the error `allowed` of each variable in one step.
void through_window(const RightHandSide& derivative, Eigen::VectorXd& x, double length,
                    const Eigen::VectorXd& allowed, const WindowLimits& limits, double& step,
                    const StepBegin& on_step);

}  // namespace orbearing::integration
