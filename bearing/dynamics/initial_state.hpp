// Where a run begins: quasi-static places and loads, kinematic speeds.
#pragma once

#include <Eigen/Core>

#include "bearing/dynamics/model.hpp"

namespace orbearing::bearing::dynamics {

/// A state to start from, and how the quasi-static solver got there.
struct InitialState {
  Eigen::VectorXd x;
  SolverReport report;
};

/// For steady speeds, or for the speeds of a run-up at t = 0 (its Euler terms are left to the motion).
/// Rollers stand where the quasi-static bearing has them, with the approach their loads need; rollers and
/// cage turn at pure rolling, or the cage at the reference speed that was asked for; the cage is centred in
/// its land; the pin is displaced as its support demands. Where the quasi-static solver fails, `report` says
/// so and the rings are centred.
InitialState initial_state(const CylindricalRollerBearing& bearing, const BearingModel& model,
                           const DynamicsParameters& parameters, double first_roller);

}  // namespace orbearing::bearing::dynamics
