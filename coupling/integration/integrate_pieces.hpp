// Integration of equations whose right-hand side jumps at known times: steps end exactly there.
#pragma once

#include "coupling/integration/integrate.hpp"
#include "gearset/dynamics/model.hpp"

namespace orbearing::integration {

/// Jumps of the right-hand side: time [s] of jump `index`, growing with the index from 0 on; beyond the last
/// one infinity. Jumps before the start of the run are passed over.
struct Jumps {
  std::function<double(long index)> time;
  /// [s] The right-hand side is evaluated at no time nearer to a jump than this, so that it is on the correct
  /// side of it; it must change little over this time.
  double margin = 0.0;
};

/// As `integrate` with Method::dopri5, piece by piece between jumps. Allowed errors, budget and report as
/// there.
IntegrationReport integrate_pieces(const RightHandSide& derivative, Eigen::VectorXd& x,
                                   const OutputTimes& output, const Jumps& jumps,
                                   const IntegrationOptions& options, const Observer& observe);

// Data of a planetary set for the integrator: jumps of its right-hand side, and allowed errors of a step.

/// Jumps of the right-hand side of `model`, for integrate_pieces. The first are those of the mesh period in
/// which `from` [s] lies, so that windows late in a run need not pass over all that went before.
Jumps jumps_of(const gearset::dynamics::SetModel& model, double from = 0.0);

/// Errors allowed in one step: of positions a share of the largest mean mesh deflection, of velocities that
/// times the frequency of a planet between its meshes.
Eigen::VectorXd gear_allowed_errors(const gearset::dynamics::SetModel& model, double share);

}  // namespace orbearing::integration
