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

}  // namespace orbearing::integration::detail
