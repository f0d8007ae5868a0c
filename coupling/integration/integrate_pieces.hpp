// Integration of equations whose right-hand side jumps at known times: steps end exactly there.
#pragma once

#include "coupling/integration/integrate.hpp"

namespace orbearing::integration {

/// Where the right-hand side jumps: time [s] of jump `index`, growing with the index from 0 on; beyond the
/// last one infinity. Jumps before the start of the run are passed over.
struct Jumps {
  std::function<double(long index)> time;
  /// [s] The right-hand side is asked for no time nearer to a jump than this, so that it answers for the
  /// right side of it; it shall change little over this time.
  double margin = 0.0;
};

/// Sees the state at a jump: `before` and `after` [s] are the times that the right-hand side is asked for on
/// its two sides.
using JumpObserver =
    std::function<void(double before, double after, const Eigen::Ref<const Eigen::VectorXd>& x)>;

/// As `integrate` with Method::dopri5, piece by piece between jumps. Allowed errors, budget and report as
/// there.
IntegrationReport integrate_pieces(const RightHandSide& derivative, Eigen::VectorXd& x,
                                   const OutputTimes& output, const Jumps& jumps,
                                   const IntegrationOptions& options, const Observer& observe,
                                   const JumpObserver& at_jump = {});

}  // namespace orbearing::integration
