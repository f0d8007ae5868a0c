// SUNDIALS CVODE [Hindmarsh2005] as reference integrator: BDF of variable order, Newton with a dense Jacobian
// by differences.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace orbearing::bench {

/// Writes the rate `dx` of the state `x` at `time` [s].
using FlatDerivative = std::function<void(double time, const double* x, double* dx)>;
/// Sees the state at an output time.
using FlatObserver = std::function<void(double time, const double* x)>;

struct CvodeReport {
  long steps = 0;         // [-]
  long rhs_calls = 0;     // [-]  those for Jacobians included
  long jacobians = 0;     // [-]
  double end_time = 0.0;  // [s]
};

/// Integrates from `x` at time zero over `samples` equal intervals that make up `duration` [s]; the final
/// state is left in `x`. BDF takes orders up to `most_order`, at most 5. `allowed` is the allowed error of
/// each variable, without a relative part; CVODE holds the root mean square of the shares below one. Throws
/// std::runtime_error where CVODE gives up.
CvodeReport run_cvode(const FlatDerivative& derivative, Eigen::VectorXd& x, double duration, long samples,
                      const Eigen::VectorXd& allowed, int most_order, const FlatObserver& observe);

}  // namespace orbearing::bench
