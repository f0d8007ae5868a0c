// One bearing run in time by each of the integrators that are compared, from the same state.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bearing/motion/vector_bearing.hpp"
#include "benchmarks/clocks.hpp"
#include "benchmarks/load_tally.hpp"
#include "benchmarks/reducer.hpp"

namespace orbearing::bench {

/// Means over one run by which the integrators are compared.
struct RunMeans {
  double inner_rms = 0.0;   // [N]      of one roller, over all rollers
  double outer_rms = 0.0;   // [N]
  double load_max = 0.0;    // [N]      of both races
  double cage_speed = 0.0;  // [rad/s]  relative to the carrier
};

/// Result of a run.
struct Run {
  Eigen::VectorXd state;      // at the end
  RunMeans means;             // of an observed run
  long steps = 0;             // [-]  accepted
  double cpu_seconds = 0.0;   // [s]  of this thread
  double wall_seconds = 0.0;  // [s]
};

/// Duration and samples of a run. Runs without samples are for timing.
struct Span {
  double duration = 0.0;  // [s]
  long samples = 0;       // [-]  0: loads are not gathered
};

/// The integrators that are compared.
enum class Method {
  fast,          // vectorised equations, linearly implicit stepper
  fast_dopri5,   // vectorised equations, Odeint's controlled dopri5
  plain_dopri5,  // frozen plain equations (frozen/), Odeint's controlled dopri5
  cvode,         // vectorised equations, SUNDIALS CVODE BDF with dense Jacobian by differences
  cvode_order2,  // the same with its order held at two, where BDF damps the ring's resonance
  rk4,           // vectorised equations, classic Runge-Kutta at the fixed step `tolerance` [s]: the reference
};

/// A bearing with all integrators; not for use by two threads at once.
class Contest {
 public:
  explicit Contest(const Duty& duty);

  /// State with the positions of rollers and rings of the quasi-static bearing.
  Eigen::VectorXd quasi_static_start() const;
  /// The state after quasi-static start and `duration` [s] by the fast path.
  Eigen::VectorXd settled(double duration);
  /// Runs from `start` by `method`. `tolerance` [m] is the allowed error of lengths in one step, from which
  /// those of all other variables follow; the fast path turns it into its own (bearing_steps.hpp). Throws
  /// std::runtime_error where the integrator gives up.
  Run run(Method method, const Eigen::VectorXd& start, const Span& span, double tolerance);

  bearing::vectorised::VectorBearing& fast() { return fast_; }
  const Duty& duty() const { return duty_; }
  /// Allowed error of each variable in one step.
  Eigen::VectorXd allowed(double length) const;

 private:
  Run run_fast(const Eigen::VectorXd& start, const Span& span, double tolerance);
  Run run_odeint(Method method, const Eigen::VectorXd& start, const Span& span, double tolerance);
  Run run_cvode(const Eigen::VectorXd& start, const Span& span, double tolerance, int most_order);
  void finish(const Stopwatch& watch, const Eigen::VectorXd& start, const Span& span, const LoadTally& tally,
              Run& result) const;
  void derivative(double time, const double* x, double* dx);

  Duty duty_;
  bearing::motion::BearingModel model_;
  bearing::vectorised::VectorBearing fast_;
};

}  // namespace orbearing::bench
