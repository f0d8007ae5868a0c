// What a bearing did to its bore in a linearly implicit step: mean over the step, as the step has it.
#pragma once

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/vectorised/engine.hpp"

namespace orbearing::system {

/// Sums up the stages of one attempted step of ROS2. Eq. (3) of coupling/system/README.md.
class StageReactions {
 public:
  /// An attempt begins, at `now`.
  void begin(const bearing::motion::BoreReaction& now) {
    now_ = now;
    sum_ = {};
  }
  /// The right-hand side of the next stage was asked for.
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

}  // namespace orbearing::system
