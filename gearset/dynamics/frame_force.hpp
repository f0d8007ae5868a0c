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
  const double rotating = model.operation.speeds.carrier * speed.factor;
  return {rotating, on.coriolis ? rotating : 0.0, on.centrifugal ? rotating * rotating : 0.0,
          on.euler ? model.operation.speeds.carrier * speed.rate : 0.0};
}

/// Velocity [m/s] relative to the housing, in the axes of the carrier, of a point that moves in its frame.
inline Eigen::Vector2d velocity_in_housing(const CarrierTurn& turn, const Eigen::Vector2d& position,
                                           const Eigen::Vector2d& velocity) {
  return velocity + turn.speed * Eigen::Vector2d(-position.y(), position.x());
}

/// Acceleration [m/s^2] that the frame adds to a central member at `position` from the axis. Eq. (8) of
/// gearset/dynamics/README.md.
inline Eigen::Vector2d frame_acceleration(const CarrierTurn& turn, const Eigen::Vector2d& position,
                                          const Eigen::Vector2d& velocity) {
  return 2.0 * turn.coriolis * Eigen::Vector2d(velocity.y(), -velocity.x()) + turn.centrifugal * position +
         turn.euler * Eigen::Vector2d(position.y(), -position.x());
}

/// The same for a planet at the centre distance `radius` [m]. Its x and y are distances along the radius and
/// along the circle, so that a rotation of the whole set as a rigid body stays free of centrifugal forces: in
/// cartesian axes these would push it on and on. Eq. (9).
inline Eigen::Vector2d planet_frame_acceleration(const CarrierTurn& turn, double radius, double outward,
                                                 const Eigen::Vector2d& velocity) {
  return {2.0 * turn.coriolis * velocity.y() + turn.centrifugal * (radius + outward),
          -2.0 * turn.coriolis * velocity.x() - turn.euler * (radius + 2.0 * outward)};
}

/// Forces [N] of Eqs. (8) and (9) on all bodies.
inline void add_frame_forces(const SetModel& model, const CarrierTurn& turn,
                             const Eigen::Ref<const Eigen::VectorXd>& q,
                             const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> force) {
  for (Eigen::Index index = 0; index < SetLayout::planet(0); index += 3)
    force.segment<2>(index) +=
        model.mass[index] * frame_acceleration(turn, q.segment<2>(index), v.segment<2>(index));
  const double radius = model.parameters.carrier.radius;
  for (Eigen::Index index = SetLayout::planet(0); index < model.layout.freedoms(); index += 3)
    force.segment<2>(index) +=
        model.mass[index] * planet_frame_acceleration(turn, radius, q[index], v.segment<2>(index));
}

/// Weight [N] of the planets. Gravity turns against the carrier; the first planet begins on the horizontal.
void add_weights(const SetModel& model, double time, Eigen::Ref<Eigen::VectorXd> force);

/// Forces [N] on the rotations as their nominal speeds rise; planets are carried round as well.
void add_run_up_forces(const SetModel& model, const SpeedState& speed, Eigen::Ref<Eigen::VectorXd> force);

/// Power [W] that raises the nominal speeds of all bodies.
double run_up_power(const SetModel& model, const SpeedState& speed);

}  // namespace orbearing::gearset::dynamics
