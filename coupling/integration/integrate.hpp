// Integration of ordinary differential equations x' = f(t, x): the one place where an integrator runs.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "bearing/dynamics/layout.hpp"

namespace orbearing::integration {

/// Writes the rate `dx` of the state `x` at `time` [s]; must not allocate if the steps shall not.
using RightHandSide = std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                         Eigen::Ref<Eigen::VectorXd> dx)>;
/// Sees the state at each output time.
using Observer = std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& x)>;

enum class Method {
  dopri5,             // Dormand and Prince 5(4) [DormandPrince1980], controlled, output by its dense formula
  fixed_dopri5,       // the same formula of order 5 at a fixed step
  rk4,                // classic Runge-Kutta at a fixed step: the reference
  linearly_implicit,  // Rosenbrock2 on the vectorised bearing: integrate_bearing()
};

struct IntegrationOptions {
  Method method = Method::dopri5;
  double tolerance = 1.0;         // [-]  largest share of the allowed error of each variable in one step
  Eigen::VectorXd allowed_error;  // allowed error of each variable in one step, in its own unit; dopri5 only
  double step = 1e-6;             // [s]  first step of dopri5, every step of the others
  double smallest_step = 1e-13;   // [s]  below it dopri5 gives up
  long most_steps = 100'000'000;  // [-]  accepted steps before the run is given up
  double most_seconds = 3600.0;   // [s]  of wall time before the run is given up
};

/// How an integration ended.
struct IntegrationReport {
  bool completed = false;
  double reached = 0.0;        // [s]
  long steps = 0;              // [-]  accepted
  long rejected = 0;           // [-]
  long rhs_calls = 0;          // [-]
  double smallest_step = 0.0;  // [s]  accepted
  double next_step = 0.0;      // [s]  that the error allows from here; integrate_pieces() alone
  double wall_seconds = 0.0;   // [s]
  std::string message;         // empty when completed
};

/// Adds to `all` the part of a run that follows it.
void append(const IntegrationReport& part, IntegrationReport& all);

/// Output times start, start + interval, ..., `samples` intervals in all.
struct OutputTimes {
  double start = 0.0;     // [s]
  double interval = 0.0;  // [s]
  long samples = 0;       // [-]

  double time(long sample) const { return start + static_cast<double>(sample) * interval; }
};

/// Integrates from `x` at the first output time to the last and leaves the final state in `x`. `observe` is
/// called after each interval, not at the start; it may be empty. A state that is no longer finite, a step
/// too small and an exhausted budget end the run with a message; `x` is then the last good state.
IntegrationReport integrate(const RightHandSide& derivative, Eigen::VectorXd& x, const OutputTimes& output,
                            const IntegrationOptions& options, const Observer& observe);

/// Allowed errors of a bearing's state by kind: no share relative to angles, which grow. `length` [m] sets
/// all: angles follow by `radius` [m], speeds by `frequency` [rad/s], that of a roller between its races.
Eigen::VectorXd bearing_allowed_errors(const bearing::dynamics::StateLayout& layout, double length,
                                       double radius, double frequency);

}  // namespace orbearing::integration
