// Options of an integration of x' = f(t, x), and its report.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "mechanics/described.hpp"

namespace orbearing::integration {

/// Writes the rate `dx` of the state `x` at `time` [s]; must not allocate if the steps shall not.
using RightHandSide = std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                         Eigen::Ref<Eigen::VectorXd> dx)>;
/// Sees the state at each output time.
using Observer = std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& x)>;

/// Output times start, start + interval, ..., `samples` intervals in all, after the first `passed` ones.
struct OutputTimes {
  double start = 0.0;     // [s]
  double interval = 0.0;  // [s]
  long samples = 0;       // [-]
  long passed = 0;        // [-]  so that runs in turn keep to multiples of one interval

  double time(long sample) const { return start + static_cast<double>(passed + sample) * interval; }
};

enum class Method {
  dopri5,             // Dormand and Prince 5(4) [DormandPrince1980], controlled, output by its dense formula
  fixed_dopri5,       // the same formula of order 5 at a fixed step
  rk4,                // classic Runge-Kutta at a fixed step: the reference
  linearly_implicit,  // Rosenbrock2, 3 or 4 on the vectorised bearing: system::integrate_bearing()
};

/// Those that a case may choose.
constexpr described::Names<Method, 2> names_of(Method) {
  return {{{Method::linearly_implicit, "linearly-implicit"}, {Method::dopri5, "dopri5"}}};
}

struct IntegrationOptions {
  Method method = Method::dopri5;
  double tolerance = 1.0;         // [-]  largest share of the allowed error of each variable in one step
  Eigen::VectorXd allowed_error;  // allowed error of each variable in one step, in its own unit; dopri5 only
  double step = 1e-6;             // [s]  first step of dopri5, every step of the others
  double smallest_step = 1e-13;   // [s]  below it dopri5 gives up
  long most_steps = 100'000'000;  // [-]  accepted steps before the run is given up
  double most_seconds = 3600.0;   // [s]  of wall time before the run is given up
};

/// Result of an integration.
struct IntegrationReport {
  bool completed = false;
  double reached = 0.0;        // [s]
  long steps = 0;              // [-]  accepted
  long rejected = 0;           // [-]
  long rhs_calls = 0;          // [-]
  double smallest_step = 0.0;  // [s]  accepted
  double next_step = 0.0;      // [s]  that the error allows from here; integrate_pieces() only
  double wall_seconds = 0.0;   // [s]
  std::string message;         // empty when completed
};

}  // namespace orbearing::integration
