// Slopes of all forces of the set by positions and velocities, for implicit integrators.
#pragma once

#include <Eigen/Core>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Slopes of the generalised forces.
struct ForceSlopes {
  Eigen::MatrixXd by_position;  // [N/m]    (freedoms, freedoms)
  Eigen::MatrixXd by_velocity;  // [N s/m]  (freedoms, freedoms)
};

/// Slopes of what `add_forces` gives at `time` [s] and `x`, with the flanks that touch there. `slopes` is
/// resized where it has not the right size. Coupled bearings have no part in it.
void force_slopes(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                  ForceSlopes& slopes);

}  // namespace orbearing::gearset::dynamics
