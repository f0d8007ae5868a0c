// The vectorised bearing under prescribed inputs, as the linearly implicit stepper sees it.
#pragma once

#include <algorithm>
#include <vector>

#include "bearing/fast/vector_bearing.hpp"
#include "coupling/cosim/driven_bearing.hpp"
#include "coupling/cosim/load_sums.hpp"

namespace orbearing::cosim {

/// Loads of the state from which a step begins; they count for half the step before and half the one after.
struct LoadsAtStep {
  std::vector<double> angle, inner, outer;                      // [rad], [N]  (rollers)
  double step_before = 0.0;                                     // [s]
  bearing::dynamics::StatisticsCollector* collector = nullptr;  // gets them too, where there is one

  explicit LoadsAtStep(int rollers) : angle(static_cast<std::size_t>(rollers)), inner(angle), outer(angle) {}

  void take(const double* angles, const bearing::fast::ContactLoads& loads) {
    std::copy_n(angles, angle.size(), angle.begin());
    std::copy_n(loads.inner, inner.size(), inner.begin());
    std::copy_n(loads.outer, outer.size(), outer.begin());
  }
  void count(double step, LoadSums& sums) {
    const double time = 0.5 * (step_before + step);
    sums.add(time, static_cast<Eigen::Index>(angle.size()), angle.data(), inner.data(), outer.data());
    if (collector) collector->add_loads(time, angle.data(), inner.data(), outer.data());
    step_before = step;
  }
};

/// Times count from the beginning of the window. The rate of the bore's velocity is given, so its row in the
/// matrix is that of the unit matrix.
class DrivenSystem {
 public:
  DrivenSystem(bearing::fast::VectorBearing& bearing, const BoreCourse& inputs, double angle,
               LoadsAtStep& loads, LoadSums& sums)
      : bearing_(bearing),
        inputs_(inputs),
        angle_(integral(angle, inputs.speed)),
        loads_(loads),
        sums_(sums) {}

  bearing::dynamics::BoreMotion at(double time) const {
    bearing::dynamics::BoreMotion motion = inputs_.at(time);
    motion.angle = angle_.at(time);
    return motion;
  }

  void linearise(double time, const double* x, double* dx) { bearing_.linearise(at(time), x, dx); }
  void derivative(double time, const double* x, double* dx) { bearing_.derivative(at(time), x, dx); }
  /// That of the bore's acceleration; speeds and frame change little in a step, and the order does not ask
  /// for theirs.
  void time_slope(double time, double* rate) const {
    const int bore = bearing_.layout().bore();
    std::fill_n(rate, bearing_.layout().size(), 0.0);
    rate[bore + 2] = second_slope(inputs_.v_x, time);
    rate[bore + 3] = second_slope(inputs_.v_y, time);
  }
  bool factor(double g) { return bearing_.factor_open(g, port_); }
  void solve(const double* rhs, double* k) {
    const int bore = bearing_.layout().bore();
    const double rate[2] = {rhs[bore + 2], rhs[bore + 3]};
    double force[2];
    bearing_.reduce(rhs, k, force);
    bearing_.complete(rhs, rate, k);
  }

  void begun(const std::vector<double>& x) {
    loads_.take(x.data() + bearing_.layout().lanes(), bearing_.loads());
  }
  void stepped(double, double length) { loads_.count(length, sums_); }
  void settle(double time, std::vector<double>& x) const { put(at(time), x); }

  /// Puts the bore where `motion` says.
  void put(const bearing::dynamics::BoreMotion& motion, std::vector<double>& x) const {
    double* bore = x.data() + bearing_.layout().bore();
    std::copy_n(motion.position.data(), 2, bore);
    std::copy_n(motion.velocity.data(), 2, bore + 2);
  }

 private:
  static double second_slope(const Course& course, double since) {
    return 2.0 * course.coefficient[2] + 6.0 * since * course.coefficient[3];
  }

  bearing::fast::VectorBearing& bearing_;
  const BoreCourse& inputs_;
  Course angle_;
  LoadsAtStep& loads_;
  LoadSums& sums_;
  bearing::fast::PortMatrix port_;
};

}  // namespace orbearing::cosim
