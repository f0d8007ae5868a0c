// Where the set rests under its mean loads.
#pragma once

#include <Eigen/Core>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// State at rest in the carrier's frame with mean mesh stiffness and mean errors, centrifugal forces
/// included. Of the rotations that cost nothing, none takes place. Solved for the flanks in contact, until
/// those found in contact are the same.
/// @throws std::runtime_error where no equilibrium is found
Eigen::VectorXd static_state(const SetModel& model);

}  // namespace orbearing::gearset::dynamics
