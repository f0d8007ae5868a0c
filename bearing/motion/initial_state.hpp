// Start of a run: quasi-static positions and loads, kinematic speeds.
#pragma once

#include <Eigen/Core>

#include "bearing/motion/model.hpp"

namespace orbearing::bearing::motion {

/// A state to start from, and how the quasi-static solver got there.
struct InitialState {
  Eigen::VectorXd x;
  SolverReport report;
};

/// For steady speeds, or for the speeds of a run-up at t = 0 (its Euler terms are left to the motion).
/// Rollers are at their quasi-static positions, with the approach that their loads require. Rollers and cage
/// turn at pure rolling; the cage is centred in its land; the
/// pin is displaced by the deflection of its support. If the quasi-static solver fails, `report` states it
/// and the rings are centred.
InitialState initial_state(const Bearing& bearing, const BearingModel& model,
                           const DynamicsParameters& parameters, double first_roller);

/// Film and inertia of a quasi-static start.
QuasiStaticOptions start_options(const DynamicsParameters& parameters);

/// Positions of the rings at the start, and speeds of cage and rollers.
struct StartMotion {
  Vector2 pin;              // [m]
  Vector2 bore;             // [m]
  double cage_speed = 0.0;  // [rad/s]
  double spin = 0.0;        // [rad/s]
};

/// Puts all bodies into the state `x`, which is zero before: rollers as `balance` has them between rings at
/// `start`, with the approach that their loads need on `contacts`; the cage centred in its land.
void place_bodies(const BearingModel& model, const bearing::RollerContacts& contacts,
                  const QuasiStaticState& balance, const StartMotion& start, double first_roller,
                  Eigen::Ref<Eigen::VectorXd> x);

}  // namespace orbearing::bearing::motion
