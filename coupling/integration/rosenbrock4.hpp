// The linearly implicit stepper of order 4. It requires one right-hand side besides that of the
// linearisation, as those of order 2 and 3 do.
//
// With M = (1 - gamma h J)^-1, gamma = 1/4, f and f_t the rate and its slope by time where the step begins:
//   k1 = M (f + gamma h f_t)
//   ki = M (k(i-1) + gamma h f_t),   i = 2, 3, 4
//   r  = f(t + 3/4 h, x + h (k1/4 + 3/8 k2 + 3/8 k3 - k4/4)) + k1/2 - 5/2 k3 + k4
//   k5 = M (k4 + 64/27 r + gamma h f_t)
//   x(t + h) = x + h (k1/4 - k2/3 + 13/6 k3 - 4/3 k4 + k5/4)
// A Rosenbrock method in the sense of [Hairer1996], section IV.7, whose first four stages solve the
// linearised equations. Since gamma h J ki + gamma h f_t = ki - k(i-1), r is what the true rate has beyond
// the linear one at its argument; it is of order h^2.
//
// For linear equations the step is the rational approximation of order 4 whose pole 1/gamma is fivefold,
// L-stable: a vibration of w h = 0.3 loses less than a millionth of its amplitude in a period, with ROS3 half
// a per cent.
//
// r enters with b h M = b h (1 + h J/4 ...), b = 16/27, from an argument at c = 3/4 that is the solution to
// order 3 (and for large h J the linear one's limit). That meets the conditions of order 4 that contain
// derivatives of f by state and time:
//   f''     b c^2 = 1/3
//   J f''   b c^2/4 = 1/12
//   f''(J)  b c c^2/2 = 1/8
//   f'''    b c^3 = 1/4
// It requires the true Jacobian: for slopes that J lacks, b c is 4/9 instead of 1/2.
//
// Error estimate h/4 (k2 - 3 k3 + 3 k4 - k5): the last stage left out, the whole of what r adds among it.
#pragma once

#include "coupling/integration/rosenbrock2.hpp"

namespace orbearing::integration {

/// The formula above.
struct FourthOrder {
  static constexpr int kOrder = 4, kStages = 5;
  static constexpr double kGamma = 0.25;
  static constexpr double kReach = 0.75;
  static constexpr double kRemainder = 64.0 / 27.0;
  static constexpr double kForward[] = {0.25, -1.0 / 3.0, 13.0 / 6.0, -4.0 / 3.0, 0.25};
  static constexpr double kError[] = {0.0, 0.25, -0.75, 0.75, -0.25};

  template <class System>
  static double attempt(System& system, const std::vector<double>& x, double t, double h,
                        const double* weight, StageArrays<kStages>& s) {
    const std::size_t n = x.size();
    const double g = kGamma * h;
    double *k1 = s.k[0].data(), *k2 = s.k[1].data(), *k3 = s.k[2].data(), *k4 = s.k[3].data(),
           *k5 = s.k[4].data(), *next = s.next.data(), *rhs = s.rhs.data(), *rate = k5;
    const double* by_time = s.time_slope.data();
    const double* before = s.slope.data();
    for (double* k : {k1, k2, k3, k4}) {
      detail::add_scaled(before, g, by_time, rhs, n);
      system.solve(rhs, k);
      before = k;
    }
    detail::add_terms(x.data(), {0.25 * h, k1}, {0.375 * h, k2}, next, n);
    detail::add_terms(next, {0.375 * h, k3}, {-0.25 * h, k4}, next, n);
    system.derivative(t + kReach * h, next, rate);
    detail::add_terms(k4, {kRemainder, rate}, {0.5 * kRemainder, k1}, {-2.5 * kRemainder, k3}, rhs, n);
    detail::add_terms(rhs, {kRemainder, k4}, {g, by_time}, rhs, n);
    system.solve(rhs, k5);
    return detail::finish(x.data(), h, {k1, k2, k3, k4, k5}, kForward, kError, weight, next, n);
  }
};
using Rosenbrock4 = Rosenbrock<FourthOrder>;

}  // namespace orbearing::integration
