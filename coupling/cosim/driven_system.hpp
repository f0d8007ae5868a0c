// The vectorised bearing under prescribed inputs, as the linearly implicit stepper sees it.
#pragma once

#include <algorithm>
#include <vector>

#include "bearing/life/damage.hpp"
#include "bearing/motion/statistics.hpp"
#include "bearing/motion/vectorised/vector_bearing.hpp"
#include "coupling/cosim/driven_setup.hpp"

namespace orbearing::cosim {

/// Loads of the state from which a step begins; they count for half the step before and half the one after.
struct LoadsAtStep {
  std::vector<double> angle, orbital_speed, inner, outer;   // [rad], [rad/s], [N]  (rollers)
  std::vector<double> inner_approach, outer_approach, tip;  // [m]  (rollers) or none
  const bearing::dynamics::LaminaRaces* laminae = nullptr;  // where they are counted one by one
  bearing::dynamics::RaceSpeeds races;
  double step_before = 0.0;                                     // [s]
  bearing::dynamics::StatisticsCollector* collector = nullptr;  // gets them too, where there is one

  explicit LoadsAtStep(int rollers)
      : angle(static_cast<std::size_t>(rollers)), orbital_speed(angle), inner(angle), outer(angle) {}

  void take(const bearing::dynamics::RollerLoads& loads) {
    std::copy_n(loads.angle, angle.size(), angle.begin());
    std::copy_n(loads.orbital_speed, angle.size(), orbital_speed.begin());
    std::copy_n(loads.inner, inner.size(), inner.begin());
    std::copy_n(loads.outer, outer.size(), outer.begin());
    races = loads.races;
    laminae = uneven_laminae(loads.laminae) > 0 ? loads.laminae : nullptr;
    if (!laminae) return;
    inner_approach.assign(loads.inner_approach, loads.inner_approach + angle.size());
    outer_approach.assign(loads.outer_approach, loads.outer_approach + angle.size());
    tip.assign(loads.tip, loads.tip + angle.size());
  }
  /// Those of the padded state `x`, at which `bearing` was evaluated last, with its bore at `bore_speed`
  /// [rad/s].
  void take(const bearing::fast::VectorBearing& bearing, const double* x, double bore_speed) {
    const int lanes = bearing.layout().lanes();
    const bearing::fast::ContactLoads loads = bearing.loads();
    take({x + lanes, x + 3 * lanes, loads.inner, loads.outer,
          bearing::dynamics::race_speeds(bearing.model().geometry, 0.0, bore_speed),
          cut_races(bearing.model()), loads.inner_approach, loads.outer_approach, loads.tip});
  }
  void count(double step, bearing::dynamics::DamageSums& sums) {
    const double time = 0.5 * (step_before + step);
    const bearing::dynamics::RollerLoads loads{
        angle.data(), orbital_speed.data(),  inner.data(),          outer.data(), races,
        laminae,      inner_approach.data(), outer_approach.data(), tip.data()};
    sums.add(time, static_cast<Eigen::Index>(angle.size()), loads);
    if (collector) collector->add_loads(time, loads);
    step_before = step;
  }
};

/// Times count from the beginning of the window. The rate of the bore's velocity is given, so its row in the
/// matrix is that of the unit matrix.
class DrivenSystem {
 public:
  DrivenSystem(bearing::fast::VectorBearing& bearing, const BoreCourse& inputs, double angle,
               LoadsAtStep& loads, bearing::dynamics::DamageSums& sums)
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

  void linearise(double time, const double* x, double* dx) {
    const bearing::dynamics::BoreMotion motion = at(time);
    bore_speed_ = motion.speed;
    bearing_.linearise(motion, x, dx);
  }
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

  void begun(const std::vector<double>& x) { loads_.take(bearing_, x.data(), bore_speed_); }
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
  bearing::dynamics::DamageSums& sums_;
  double bore_speed_ = 0.0;  // [rad/s]  at the last linearisation
  bearing::fast::PortMatrix port_;
};

}  // namespace orbearing::cosim
