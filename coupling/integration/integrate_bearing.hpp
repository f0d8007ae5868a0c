// Integration of the vectorised bearing by the linearly implicit stepper.
#pragma once

#include "bearing/motion/vectorised/vector_bearing.hpp"
#include "coupling/integration/integrate.hpp"

namespace orbearing::integration {

/// What a step leaves behind: the state at its beginning and how long that state counts.
struct StepSample {
  double time = 0.0;                   // [s]
  double weight = 0.0;                 // [s]  half of the step before and half of the one after
  const double* state = nullptr;       // padded
  const double* inner_load = nullptr;  // [N]  one for each roller
  const double* outer_load = nullptr;  // [N]
  Eigen::Vector2d bore_force = Eigen::Vector2d::Zero();  // [N]  of the bearing on the bore
  /// Where contacts that are cut into laminae stand [m], one for each roller; else null.
  const double* inner_approach = nullptr;
  const double* outer_approach = nullptr;
  const double* tip = nullptr;
};
using StepObserver = std::function<void(const StepSample&)>;

/// Allowed errors of linearly implicit steps are this much larger than those of dopri5 at equal accuracy of
/// loads and speeds: the error estimate is that of the first-order step within, and stiff parts of it die out
/// by themselves.
inline constexpr double kLinearlyImplicitErrorFactor = 1000.0;

/// As integrate(), for `bearing` by Rosenbrock2; `options.allowed_error` is that of dopri5. `observe` sees
/// interpolated states at the output times, `on_step` every accepted step; either may be empty.
IntegrationReport integrate_bearing(bearing::fast::VectorBearing& bearing, Eigen::VectorXd& x,
                                    const OutputTimes& output, const IntegrationOptions& options,
                                    const Observer& observe, const StepObserver& on_step);

/// Allowed errors of linearly implicit steps of the padded state, from those of dopri5.
std::vector<double> linearly_implicit_errors(const bearing::fast::VectorBearing& bearing,
                                             const Eigen::VectorXd& allowed_error);

/// Frequency of a roller between its races at a typical approach [rad/s]: ties the allowed errors of speeds
/// to those of lengths.
double roller_frequency(const bearing::dynamics::BearingModel& model);

/// Longest step [s] that still resolves the impact of a roller on its pocket and the ring on its rollers.
double longest_step(const bearing::dynamics::BearingModel& model);

}  // namespace orbearing::integration
