// A linearly implicit stepper of order 2 for stiff systems whose Jacobian has a structure of its own.
//
// ROS2 of [Verwer1999]: with gamma = 1 - 1/sqrt(2), L-stable,
//   (1 - gamma h J) k1 = f(t, x) + gamma h f_t
//   (1 - gamma h J) k2 = f(t + h, x + h k1) - gamma h f_t - 2 k1
//   x(t + h) = x + 3/2 h k1 + 1/2 h k2,   error estimate 1/2 h (k1 + k2), that of the first-order x + h k1.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <cmath>
#include <vector>

#include "coupling/integration/step_control.hpp"

namespace orbearing::integration {

/// What becomes of an attempted step, in Odeint's terms.
using StepResult = boost::numeric::odeint::controlled_step_result;
inline constexpr StepResult kAccepted = boost::numeric::odeint::success;
inline constexpr StepResult kRefused = boost::numeric::odeint::fail;

namespace detail {
void add_scaled(const double* x, double a, const double* y, double* z, std::size_t n);
void second_stage(const double* k1, double g, const double* time_slope, double* rhs, std::size_t n);
// The state after the step into `next`; returns the largest share of the allowed error. `n` is a multiple of
// eight.
double finish(const double* x, double h, const double* k1, const double* k2, const double* weight,
              double* next, std::size_t n);
// That share alone.
double largest_share(double h, const double* k1, const double* k2, const double* weight, std::size_t n);
}  // namespace detail

/// Controlled stepper in the sense of Odeint. `System` offers
///   linearise(t, x, dx)   rate dx at x, and keeps the Jacobian J there
///   derivative(t, x, dx)
///   time_slope(t, dx)     slope of the rate by time alone; none: it is left out, the order does not ask for it
///   bool factor(g), solve(rhs, k)   k = (1 - g J)^-1 rhs
/// on plain arrays, whose length is a multiple of eight. `allowed` holds the allowed error of each variable
/// in one step.
class Rosenbrock2 {
 public:
  using state_type = std::vector<double>;
  using deriv_type = state_type;
  using value_type = double;
  using time_type = double;
  using stepper_category = boost::numeric::odeint::controlled_stepper_tag;

  explicit Rosenbrock2(state_type allowed, double longest_step)
      : weight_(allowed.size()),
        control_(longest_step),
        slope_(allowed.size()),
        time_slope_(allowed.size()),
        rhs_(allowed.size()),
        k1_(allowed.size()),
        k2_(allowed.size()),
        next_(allowed.size()) {
    std::transform(allowed.begin(), allowed.end(), weight_.begin(),
                   [](double e) { return e > 0.0 ? 1.0 / e : 0.0; });
  }

  /// Rate at `x`, kept for the next step and whatever else is wanted there.
  template <class System>
  void begin(System& system, const state_type& x, double t) {
    system.linearise(t, x.data(), slope_.data());
    linear_ = true;
  }

  /// One attempt: on success `x` and `t` move on; `dt` becomes the step to try next in any case.
  template <class System>
  boost::numeric::odeint::controlled_step_result try_step(System& system, state_type& x, double& t,
                                                          double& dt) {
    using boost::numeric::odeint::fail;
    using boost::numeric::odeint::success;
    if (!linear_) begin(system, x, t);
    const double h = dt;
    const double error = attempt(system, x, t, h);
    if (!(error <= 1.0)) {
      dt = control_.after_refusal(h, error);
      return fail;
    }
    t += h;
    accept(x);
    dt = control_.after_acceptance(h, error);
    return success;
  }

  /// The step of length `h` from `x` at `t`, where the last linearisation is: the state after it awaits
  /// accept(). Returns the largest share of the allowed error. For those who decide on steps themselves.
  template <class System>
  double attempt(System& system, const state_type& x, double t, double h) {
    const double g = kGamma * h;
    const std::size_t n = x.size();
    constexpr bool has_time_slope = requires { system.time_slope(t, time_slope_.data()); };
    if (!system.factor(g)) return INFINITY;
    if constexpr (has_time_slope) {
      system.time_slope(t, time_slope_.data());
      detail::add_scaled(slope_.data(), g, time_slope_.data(), rhs_.data(), n);
      system.solve(rhs_.data(), k1_.data());
    } else {
      system.solve(slope_.data(), k1_.data());
    }
    detail::add_scaled(x.data(), h, k1_.data(), next_.data(), n);
    system.derivative(t + h, next_.data(), rhs_.data());
    if constexpr (has_time_slope)
      detail::second_stage(k1_.data(), g, time_slope_.data(), rhs_.data(), n);
    else
      detail::add_scaled(rhs_.data(), -2.0, k1_.data(), rhs_.data(), n);
    system.solve(rhs_.data(), k2_.data());
    return detail::finish(x.data(), h, k1_.data(), k2_.data(), weight_.data(), next_.data(), n);
  }
  /// Exchanges `x` for the state after the last attempt.
  void accept(state_type& x) {
    x.swap(next_);
    linear_ = false;
  }
  /// Rate where the last linearisation is.
  const state_type& slope() const { return slope_; }
  /// The state that accept() took away.
  const state_type& taken_away() const { return next_; }
  /// Largest share of the allowed errors 1 / `weight` in the last attempt, among `n` variables from `first`.
  double share(double h, std::size_t first, const double* weight, std::size_t n) const {
    return detail::largest_share(h, k1_.data() + first, k2_.data() + first, weight, n);
  }
  bool linear() const { return linear_; }

 private:
  static constexpr double kGamma = 0.29289321881345247559915563789515;

  state_type weight_;
  StepControl control_;
  bool linear_ = false;  // the system holds slope_ and the Jacobian at the present state
  state_type slope_, time_slope_, rhs_, k1_, k2_, next_;
};

}  // namespace orbearing::integration
