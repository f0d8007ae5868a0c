// Start of a bearing whose bore has a prescribed position.
#pragma once

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/initial_state.hpp"

namespace orbearing::bearing::motion {

/// Equilibrium of the pin ring on its support between rollers, each of which is in equilibrium.
struct PinBalance {
  Vector2 bore = Vector2::Zero();  // [m]
  Vector2 pin = Vector2::Zero();  // [m]
  QuasiStaticState rollers;       // displacement: bore less pin
};

/// The pin ring and all rollers in static equilibrium under `motion`: Newton's method on the two freedoms of
/// the pin, whose forces are the slope of a convex energy. Converged or not: see the report of `rollers`.
PinBalance balance_pin(const Bearing& bearing, const BearingModel& model,
                       const DynamicsParameters& parameters, const BoreMotion& motion, double first_roller);

/// The same with the bore in equilibrium as well, under `load` [N] of the planet on it; its position in
/// `motion` is not used. The energy is convex in all coordinates. Without load it stays where it is free to
/// move.
PinBalance balance_pin_and_bore(const Bearing& bearing, const BearingModel& model,
                                const DynamicsParameters& parameters, const BoreMotion& motion,
                                double first_roller, const Vector2& load);

/// The state from which a driven bearing of `model` begins under `motion`: pin ring and rollers as
/// balance_pin() has them, the first roller at `first_roller` [rad], rollers and cage at pure rolling, the
/// cage centred in its land. `motion` may be zero throughout. Throws std::runtime_error where no balance is
/// found, with what remains.
Eigen::VectorXd driven_start(const Bearing& bearing, const BearingModel& model,
                             const DynamicsParameters& parameters, const BoreMotion& motion,
                             double first_roller);

}  // namespace orbearing::bearing::motion
