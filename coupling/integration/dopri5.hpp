// The formula of Dormand and Prince from Odeint, with this project's error measure. Included by the sources
// of this folder alone.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "coupling/integration/integration_options.hpp"
#include "coupling/integration/run.hpp"

namespace orbearing::integration::detail {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;  // Odeint resizes and adds these without temporaries
using ConstView = Eigen::Map<const Eigen::VectorXd>;

constexpr long kRhsPerAttempt = 6;  // dopri5 takes the seventh slope over from the step before

inline ConstView view(const State& x) {
  return {x.data(), static_cast<Eigen::Index>(x.size())};
}

// Largest error of a step over what is allowed; infinite where the step is not finite, so that it is refused.
class WeightedError {
 public:
  using value_type = double;
  using algebra_type = odeint::range_algebra;
  using operations_type = odeint::default_operations;

  WeightedError() = default;
  explicit WeightedError(const IntegrationOptions& options)
      : weight_((options.tolerance * options.allowed_error.array()).inverse()) {}

  template <class Algebra, class Old, class Slope, class Error, class Time>
  double error(Algebra&, const Old&, const Slope&, Error& step_error, Time) const {
    return largest_share(step_error);
  }

 private:
  double largest_share(const State& step_error) const {
    const double largest = (view(step_error).array() * weight_).abs().maxCoeff<Eigen::PropagateNaN>();
    return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
  }

  Eigen::ArrayXd weight_;
};

using Dopri5 = odeint::runge_kutta_dopri5<State>;
using ControlledDopri5 =
    odeint::controlled_runge_kutta<Dopri5, WeightedError, odeint::default_step_adjuster<double, double>>;
using DenseDopri5 = odeint::dense_output_runge_kutta<ControlledDopri5>;

// Counts calls and hands flat states to the equations.
struct System {
  const RightHandSide& derivative;
  long& calls;

  void operator()(const State& x, State& dx, double time) const {
    ++calls;
    derivative(time, view(x), Eigen::Map<Eigen::VectorXd>(dx.data(), static_cast<Eigen::Index>(dx.size())));
  }
};

/// The report of a run from `x`, which `advance(system, run)` takes to its end: false where it was given up.
/// `starts` counts how often the stepper was started, which costs one call of the right-hand side each.
template <class Advance>
IntegrationReport reported(const RightHandSide& derivative, const Eigen::VectorXd& x,
                           const OutputTimes& output, const IntegrationOptions& options, const long& starts,
                           const Advance& advance) {
  IntegrationReport report;
  report.reached = output.time(0);
  Run run(options, report);
  if (!x.allFinite()) {
    run.fail("the state is not finite");
    return report;
  }
  report.smallest_step = std::numeric_limits<double>::infinity();
  report.completed = advance(System{derivative, report.rhs_calls}, run, report);
  if (starts > 0) report.rejected = std::max(0L, (report.rhs_calls - starts) / kRhsPerAttempt - report.steps);
  if (report.steps == 0) report.smallest_step = 0.0;
  report.wall_seconds = run.seconds();
  return report;
}

/// Dopri5 in progress, started as often as its user requires; shows the state at the output times.
class DenseRun {
 public:
  DenseRun(const OutputTimes& output, const Observer& observe, Run& run, const ControlledDopri5& controlled,
           long& starts)
      : output_(output), observe_(observe), run_(run), stepper_(controlled), starts_(starts) {}

 protected:
  void start(const State& x, double time, double step) {
    stepper_.initialize(x, time, step);
    ++starts_;
  }
  /// False where no step was small enough.
  template <class Equations>
  bool step(const Equations& equations) {
    try {
      stepper_.do_step(equations);
      return true;
    } catch (const odeint::odeint_error&) {
      return run_.fail("no step was small enough, or the state is not finite,");
    }
  }
  double last_step() const { return stepper_.current_time() - stepper_.previous_time(); }
  /// Shows the output times up to `time` that were not shown yet.
  void show_until(double time) {
    for (; sample_ <= output_.samples && output_.time(sample_) <= time; ++sample_) {
      if (!observe_) continue;
      at_sample_.resize(stepper_.current_state().size());
      stepper_.calc_state(output_.time(sample_), at_sample_);
      observe_(output_.time(sample_), view(at_sample_));
    }
  }

  const OutputTimes& output_;
  const Observer& observe_;
  Run& run_;
  DenseDopri5 stepper_;

 private:
  long& starts_;
  long sample_ = 1;
  State at_sample_;
};

}  // namespace orbearing::integration::detail
