// The linearly implicit stepper of order 3.
//
// ROS3 of [Sandu1997], L-stable, with one right-hand side besides that of the linearisation, gamma = 0.4359:
//   (1 - gamma h J) k1 = f(t, x) + gamma h f_t
//   (1 - gamma h J) k2 = f(t + gamma h, x + gamma h k1) + c21 k1 + gamma2 h f_t
//   (1 - gamma h J) k3 = f(t + gamma h, x + gamma h k1) + c31 k1 + c32 k2 + gamma3 h f_t
//   x(t + h) = x + h sum m_i k_i,   error estimate h sum e_i k_i, that of a step of order 2.
// Its order needs the true Jacobian, where Rosenbrock2 keeps order 2 with any matrix.
#pragma once

#include "coupling/integration/rosenbrock2.hpp"

namespace orbearing::integration {

/// ROS3, above: numbers of the source times gamma, since its stages are these times gamma h.
struct ThirdOrder {
  static constexpr int kOrder = 3, kStages = 3;
  static constexpr double kGamma = 0.43586652150845899941601945119356;
  static constexpr double kGamma2 = 0.24291996454816804366592249683314;
  static constexpr double kGamma3 = 2.1851380027664058511513169485832;
  static constexpr double kC21 = -1.0156171083877702091975600115545 * kGamma;
  static constexpr double kC31 = 4.0759956452537699824805835358067 * kGamma;
  static constexpr double kC32 = 9.2076794298330791242156818474003 * kGamma;
  static constexpr double kForward[] = {1.0 * kGamma, 6.1697947043828245592553615689730 * kGamma,
                                        -0.42772256543218573326238373806514 * kGamma};
  static constexpr double kError[] = {0.5 * kGamma, -2.9079558716805469821718236208017 * kGamma,
                                      0.22354069897811569627360909276199 * kGamma};

  template <class System>
  static double attempt(System& system, const std::vector<double>& x, double t, double h,
                        const double* weight, StageArrays<kStages>& s) {
    const std::size_t n = x.size();
    const double g = kGamma * h;
    double *k1 = s.k[0].data(), *k2 = s.k[1].data(), *k3 = s.k[2].data(), *next = s.next.data(),
           *rhs = s.rhs.data(), *rate = k3;
    const double* by_time = s.time_slope.data();
    detail::add_scaled(s.slope.data(), g, by_time, rhs, n);
    system.solve(rhs, k1);
    detail::add_scaled(x.data(), g, k1, next, n);
    system.derivative(t + g, next, rate);
    detail::add_terms(rate, {kC21, k1}, {kGamma2 * h, by_time}, rhs, n);
    system.solve(rhs, k2);
    detail::add_terms(rate, {kC31, k1}, {kC32, k2}, {kGamma3 * h, by_time}, rhs, n);
    system.solve(rhs, k3);
    return detail::finish(x.data(), h, {k1, k2, k3}, kForward, kError, weight, next, n);
  }
};
using Rosenbrock3 = Rosenbrock<ThirdOrder>;

}  // namespace orbearing::integration
