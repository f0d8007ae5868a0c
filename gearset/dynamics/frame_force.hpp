// Inertial forces of the turning carrier, on bodies that move in its frame.
#pragma once

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Rotation of the carrier at one instant; a term that is switched off has a zero factor.
struct CarrierTurn {
  double speed = 0.0;        // [rad/s]
  double coriolis = 0.0;     // [rad/s]      speed in the Coriolis terms
  double centrifugal = 0.0;  // [rad^2/s^2]
  double euler = 0.0;        // [rad/s^2]
};

inline CarrierTurn carrier_turn(const SetModel& model, const SpeedState& speed) {
  const FrameSwitches& on = model.parameters.frame;
  const double turning = model.operation.speeds.carrier * speed.factor;
  return {turning, on.coriolis ? turning : 0.0, on.centrifugal ? turning * turning : 0.0,
          on.euler ? model.operation.speeds.carrier * speed.rate : 0.0};
}

/// Velocity [m/s] relative to the housing, in the axes of the carrier, of a point that moves in its frame.
inline Eigen::Vector2d velocity_in_housing(const CarrierTurn& turn, const Eigen::Vector2d& position,
                                           const Eigen::Vector2d& velocity) {
  return velocity + turn.speed * Eigen::Vector2d(-position.y(), position.x());
}

/// Acceleration [m/s^2] that the frame adds to a body at `position` from the sun's axis. Eq. (8) of
/// gearset/dynamics/README.md.
inline Eigen::Vector2d frame_acceleration(const CarrierTurn& turn, const Eigen::Vector2d& position,
                                          const Eigen::Vector2d& velocity) {
  return 2.0 * turn.coriolis * Eigen::Vector2d(velocity.y(), -velocity.x()) + turn.centrifugal * position +
         turn.euler * Eigen::Vector2d(position.y(), -position.x());
}

/// Stiffness [N/m] of the carrier's u against the centrifugal pull of the planets on their pins, whose
/// direction turns with the carrier. Without it a rotation of the whole set as a rigid body would meet the
/// centrifugal terms of Eq. (8) on the planets alone, and run away. Eq. (9).
inline double centrifugal_stiffness(const SetModel& model, const CarrierTurn& turn) {
  return static_cast<double>(model.layout.planets) * model.parameters.planet.mass * turn.centrifugal;
}

/// Forces [N] of Eqs. (8) and (9) on all bodies. Planets stand at the centre distance, in axes of their own.
inline void add_frame_forces(const SetModel& model, const CarrierTurn& turn,
                             const Eigen::Ref<const Eigen::VectorXd>& q,
                             const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> force) {
  for (Eigen::Index place = 0; place < model.layout.freedoms(); place += 3) {
    Eigen::Vector2d position = q.segment<2>(place);
    if (place >= SetLayout::planet(0)) position.x() += model.parameters.carrier.radius;
    force.segment<2>(place) += model.mass[place] * frame_acceleration(turn, position, v.segment<2>(place));
  }
  force[SetLayout::carrier() + 2] -= centrifugal_stiffness(model, turn) * q[SetLayout::carrier() + 2];
}

/// Forces [N] on the rotations as their nominal speeds rise; planets are carried round as well.
void add_run_up_forces(const SetModel& model, const SpeedState& speed, Eigen::Ref<Eigen::VectorXd> force);

/// Power [W] that raises the nominal speeds of all bodies.
double run_up_power(const SetModel& model, const SpeedState& speed);

}  // namespace orbearing::gearset::dynamics
