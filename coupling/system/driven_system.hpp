// The vectorised bearing under prescribed inputs, in the form for the linearly implicit stepper.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "coupling/system/input_polynomial.hpp"
#include "coupling/system/loads_at_step.hpp"

namespace orbearing::system {

/// Reaction of a bearing on its bore in one attempted step of ROS2, mean over the step: sums up its stages.
/// Eq. (3) of coupling/system/README.md.
class StageReactions {
 public:
  /// An attempt begins, at `now`.
  void begin(const bearing::motion::BoreReaction& now) {
    now_ = now;
    sum_ = {};
  }
  /// The right-hand side of the next stage was evaluated.
  void evaluated(const bearing::motion::BoreReaction& now) { now_ = now; }
  /// A stage was solved: `reduced` and `port` from VectorBearing, `rate` of the bore's velocity [m/s^2] and
  /// rotation [rad/s^2].
  void solved(const double (&reduced)[3], const double (&rate)[3],
              const bearing::vectorised::PortMatrix& port) {
    const auto of_stage = [&](int i) {
      return reduced[i] - port.a[i][0] * rate[0] - port.a[i][1] * rate[1] - port.a[i][2] * rate[2];
    };
    for (int i = 0; i < 2; ++i) sum_.force[i] += now_.force[i] + of_stage(i);
    sum_.moment += now_.moment + of_stage(2);
  }
  /// [N], [N m]  after both stages
  bearing::motion::BoreReaction mean() const { return {0.5 * sum_.force, 0.5 * sum_.moment}; }

 private:
  bearing::motion::BoreReaction now_, sum_;
};

/// Turned [rad] since the start, where a window begins.
struct BoreAngles {
  double bore = 0.0;  // relative to the carrier
  double carrier = 0.0;
};

/// Times count from the beginning of the window. The rate of the bore's velocity is given, so its row in the
/// matrix is that of the unit matrix.
class DrivenSystem {
 public:
  /// `sums` take the loads, where they are given.
  DrivenSystem(bearing::vectorised::VectorBearing& bearing, const BoreInputs& inputs,
               const BoreAngles& angles, LoadsAtStep& loads, bearing::motion::DamageSums* sums = nullptr)
      : bearing_(bearing),
        inputs_(inputs),
        angle_(integral(angles.bore, inputs.speed)),
        carrier_angle_(integral(angles.carrier, inputs.carrier_speed)),
        loads_(loads),
        sums_(sums) {}

  bearing::motion::BoreMotion at(double time) const {
    bearing::motion::BoreMotion motion = inputs_.at(time);
    motion.angle = angle_.at(time);
    motion.carrier_angle = carrier_angle_.at(time);
    return motion;
  }

  /// The bearing is linearised where the window begins: its `rate` (padded) and `reaction` there are known,
  /// and so are its loads.
  void resume(const double* rate, const bearing::motion::BoreReaction& reaction) {
    known_ = rate;
    begin_ = reaction;
  }

  void linearise(double time, const double* x, double* dx) {
    const bearing::motion::BoreMotion motion = at(time);
    if (known_) {
      std::copy_n(known_, bearing_.layout().size(), dx);
      std::copy_n(motion.acceleration.data(), 2, dx + bearing_.layout().bore() + 2);
      return;
    }
    bearing_.linearise(motion, x, dx);
    begin_ = bearing_.reaction();
  }
  void derivative(double time, const double* x, double* dx) {
    bearing_.derivative(at(time), x, dx);
    reactions_.evaluated(bearing_.reaction());
  }
  /// Time derivative of the bore's acceleration; speeds, frame and gravity in it change little in a step, and
  /// the order does not require theirs.
  void time_slope(double time, double* rate) const {
    const int bore = bearing_.layout().bore();
    std::fill_n(rate, bearing_.layout().size(), 0.0);
    rate[bore + 2] = second_slope(inputs_.v_x, time);
    rate[bore + 3] = second_slope(inputs_.v_y, time);
  }
  bool factor(double g) {
    reactions_.begin(begin_);
    return bearing_.factor_open(g, false, port_);
  }
  void solve(const double* rhs, double* k) {
    const int bore = bearing_.layout().bore();
    const double rate[3] = {rhs[bore + 2], rhs[bore + 3], 0.0};
    double force[3];
    bearing_.reduce(rhs, k, force);
    bearing_.complete(rhs, rate, k);
    reactions_.solved(force, rate, port_);
  }

  void begun(const std::vector<double>& x) {
    if (std::exchange(known_, nullptr)) return;
    loads_.take(bearing_, x.data());
  }
  void stepped(double, double length) {
    loads_.count(length, sums_);
    impulse_.force += length * reactions_.mean().force;
    impulse_.moment += length * reactions_.mean().moment;
  }
  void settle(double time, std::vector<double>& x) const { put(at(time), x); }

  /// Impulse of the bearing on the bore in all steps so far [N s], [N m s].
  const bearing::motion::BoreReaction& impulse() const { return impulse_; }

  /// Sets the bore's position and velocity to those of `motion`.
  void put(const bearing::motion::BoreMotion& motion, std::vector<double>& x) const {
    double* bore = x.data() + bearing_.layout().bore();
    std::copy_n(motion.position.data(), 2, bore);
    std::copy_n(motion.velocity.data(), 2, bore + 2);
  }

 private:
  static double second_slope(const InputPolynomial& polynomial, double since) {
    return 2.0 * polynomial.coefficient[2] + 6.0 * since * polynomial.coefficient[3];
  }

  bearing::vectorised::VectorBearing& bearing_;
  const BoreInputs& inputs_;
  InputPolynomial angle_, carrier_angle_;
  LoadsAtStep& loads_;
  bearing::motion::DamageSums* sums_;
  bearing::vectorised::PortMatrix port_;
  bearing::motion::BoreReaction begin_;  // at the last linearisation
  const double* known_ = nullptr;        // rate at the beginning, if it need not be evaluated
  StageReactions reactions_;
  bearing::motion::BoreReaction impulse_;
};

}  // namespace orbearing::system
