// Linearly implicit steppers for stiff systems whose Jacobian has a structure of its own: what they share,
// and the one of order 2. That of order 3 is in rosenbrock3.hpp.
//
// ROS2 of [Verwer1999]: with gamma = 1 - 1/sqrt(2), L-stable,
//   (1 - gamma h J) k1 = f(t, x) + gamma h f_t
//   (1 - gamma h J) k2 = f(t + h, x + h k1) - gamma h f_t - 2 k1
//   x(t + h) = x + 3/2 h k1 + 1/2 h k2,   error estimate 1/2 h (k1 + k2), that of the first-order x + h k1.
#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <cmath>
#include <vector>

#include "coupling/integration/step_control.hpp"

namespace orbearing::integration {

/// Result of an attempted step, in Odeint's terms.
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
// Only that share.
double largest_share(double h, const double* k1, const double* k2, const double* weight, std::size_t n);

// Sums of arrays, each with its factor.
struct Term {
  double factor;
  const double* of;
};
// z = first + a + b (+ c).
void add_terms(const double* first, Term a, Term b, double* z, std::size_t n);
void add_terms(const double* first, Term a, Term b, Term c, double* z, std::size_t n);
// As finish(), of three or five stages: x + h sum forward_i k_i, and h sum error_i k_i.
double finish(const double* x, double h, const double* const (&k)[3], const double (&forward)[3],
              const double (&error)[3], const double* weight, double* next, std::size_t n);
double finish(const double* x, double h, const double* const (&k)[5], const double (&forward)[5],
              const double (&error)[5], const double* weight, double* next, std::size_t n);
}  // namespace detail

/// Arrays for the stages of a step: rate and its slope by time at its beginning, a right-hand side, the
/// stages, the state after the step.
template <int kStages>
struct StageArrays {
  using Array = std::vector<double>;

  explicit StageArrays(std::size_t n) : slope(n), time_slope(n), rhs(n), next(n) { k.fill(Array(n)); }

  Array slope, time_slope, rhs, next;
  std::array<Array, kStages> k;
};

/// Whether a system gives the derivative of its rate by time only.
template <class System>
concept kHasTimeSlope = requires(System& system, double* rate) {
  system.time_slope(0.0, rate);
};

/// Controlled stepper in the sense of Odeint, by `Formula`. `System` offers
///   linearise(t, x, dx)   rate dx at x, and keeps the Jacobian J there
///   derivative(t, x, dx)
///   time_slope(t, dx)     slope of the rate by time only; none: left out, order 2 does not require it
///   bool factor(g), solve(rhs, k)   k = (1 - g J)^-1 rhs
/// on plain arrays, whose length is a multiple of eight. `allowed` holds the allowed error of each variable
/// in one step.
template <class Formula>
class Rosenbrock {
 public:
  using state_type = std::vector<double>;
  using deriv_type = state_type;
  using value_type = double;
  using time_type = double;
  using stepper_category = boost::numeric::odeint::controlled_stepper_tag;

  explicit Rosenbrock(state_type allowed, double longest_step, StepRule rule = StepRule::last_error)
      : weight_(allowed.size()), control_(longest_step, Formula::kOrder, rule), stages_(allowed.size()) {
    std::transform(allowed.begin(), allowed.end(), weight_.begin(),
                   [](double e) { return e > 0.0 ? 1.0 / e : 0.0; });
  }

  /// Rate at `x`, kept for the next step and whatever else is wanted there.
  template <class System>
  void begin(System& system, const state_type& x, double t) {
    system.linearise(t, x.data(), stages_.slope.data());
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
    if (!system.factor(Formula::kGamma * h)) return INFINITY;
    if constexpr (kHasTimeSlope<System>) system.time_slope(t, stages_.time_slope.data());
    return Formula::attempt(system, x, t, h, weight_.data(), stages_);
  }
  /// Exchanges `x` for the state after the last attempt.
  void accept(state_type& x) {
    x.swap(stages_.next);
    linear_ = false;
  }
  /// Rate where the last linearisation is.
  const state_type& slope() const { return stages_.slope; }
  /// The state that accept() took away.
  const state_type& replaced_state() const { return stages_.next; }
  /// Largest share of the allowed errors 1 / `weight` in the last attempt, among `n` variables from `first`.
  double share(double h, std::size_t first, const double* weight, std::size_t n) const {
    return Formula::share(h, first, weight, n, stages_);
  }
  bool linear() const { return linear_; }
  /// Goes on as a new one would: what it does next hangs on nothing that it has done.
  void forget() {
    control_.forget();
    linear_ = false;
  }

 private:
  state_type weight_;
  StepControl control_;
  bool linear_ = false;  // the system holds the rate and the Jacobian at the present state
  StageArrays<Formula::kStages> stages_;
};

/// ROS2, above.
struct SecondOrder {
  static constexpr int kOrder = 2, kStages = 2;
  static constexpr double kGamma = 0.29289321881345247559915563789515;

  template <class System>
  static double attempt(System& system, const std::vector<double>& x, double t, double h,
                        const double* weight, StageArrays<kStages>& s) {
    const std::size_t n = x.size();
    const double g = kGamma * h;
    double *k1 = s.k[0].data(), *k2 = s.k[1].data(), *rhs = s.rhs.data();
    if constexpr (kHasTimeSlope<System>) {
      detail::add_scaled(s.slope.data(), g, s.time_slope.data(), rhs, n);
      system.solve(rhs, k1);
    } else {
      system.solve(s.slope.data(), k1);
    }
    detail::add_scaled(x.data(), h, k1, s.next.data(), n);
    system.derivative(t + h, s.next.data(), rhs);
    if constexpr (kHasTimeSlope<System>)
      detail::second_stage(k1, g, s.time_slope.data(), rhs, n);
    else
      detail::add_scaled(rhs, -2.0, k1, rhs, n);
    system.solve(rhs, k2);
    return detail::finish(x.data(), h, k1, k2, weight, s.next.data(), n);
  }
  static double share(double h, std::size_t first, const double* weight, std::size_t n,
                      const StageArrays<kStages>& s) {
    return detail::largest_share(h, s.k[0].data() + first, s.k[1].data() + first, weight, n);
  }
};
using Rosenbrock2 = Rosenbrock<SecondOrder>;

}  // namespace orbearing::integration
