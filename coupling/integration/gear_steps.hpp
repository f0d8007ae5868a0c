// What the integrator must know of a planetary set: where its right-hand side jumps, and which errors of a
// step it bears.
#pragma once

#include "coupling/integration/integrate_pieces.hpp"
#include "gearset/dynamics/model.hpp"

namespace orbearing::integration {

/// Jumps of the right-hand side of `model`, for integrate_pieces. The first are those of the mesh period in
/// which `from` [s] lies, so that windows late in a run need not pass over all that went before.
Jumps jumps_of(const gearset::dynamics::SetModel& model, double from = 0.0);

/// Errors allowed in one step: of positions a share of the largest mean mesh deflection, of velocities that
/// times the frequency of a planet between its meshes.
Eigen::VectorXd gear_allowed_errors(const gearset::dynamics::SetModel& model, double share);

}  // namespace orbearing::integration
