// The steppers of Odeint as this project uses them, and what every run shares: error measure, count of calls,
// budget. Included by the sources of this folder alone.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "coupling/integration/integrate.hpp"

namespace orbearing::integration::detail {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;  // Odeint resizes and adds these without temporaries
using ConstView = Eigen::Map<const Eigen::VectorXd>;
using Clock = std::chrono::steady_clock;

constexpr long kRhsPerAttempt = 6;  // dopri5 takes the seventh slope over from the step before
constexpr long kStepsPerClockRead = 256;

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

// What all methods share: budget, report, output.
class Run {
 public:
  Run(const IntegrationOptions& options, IntegrationReport& report)
      : options_(options), report_(report), begin_(Clock::now()) {}

  bool accept(double time, double step) {
    ++report_.steps;
    report_.reached = time;
    report_.smallest_step = std::min(report_.smallest_step, step);
    if (report_.steps > options_.most_steps) return fail("the largest number of steps was taken");
    if (report_.steps % kStepsPerClockRead == 0 && seconds() > options_.most_seconds)
      return fail("the allowed wall time was used up");
    if (step < options_.smallest_step) return fail("the step fell below the smallest allowed");
    return true;
  }

  bool fail(const std::string& reason) {
    std::ostringstream text;
    text << reason << " at t = " << report_.reached << " s after " << report_.steps << " steps";
    report_.message = text.str();
    return false;
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  const IntegrationOptions& options_;
  IntegrationReport& report_;
  Clock::time_point begin_;
};

}  // namespace orbearing::integration::detail
