// Speeds and torques of the members of one set, by Willis' equation and the balance of power.
#pragma once

#include "gearset/parameters.hpp"

namespace orbearing::gearset {

/// Angular speeds, all in one sense of rotation, in which the carrier does not turn backwards.
struct Speeds {
  double sun = 0.0;              // [rad/s]  relative to the housing
  double ring = 0.0;             // [rad/s]
  double carrier = 0.0;          // [rad/s]  never negative
  double planet_relative = 0.0;  // [rad/s]  of the planet about its own axis, relative to the carrier
};

/// External torques on the members, positive in the sense of positive speed.
struct Torques {
  double sun = 0.0;      // [N m]
  double ring = 0.0;     // [N m]
  double carrier = 0.0;  // [N m]
};

/// Speeds and torques of a set's members within a drivetrain, for each unit of the speed and of the torque by
/// which power enters that drivetrain: both are linear in them.
struct MemberRatios {
  Speeds speed;    // [-]  in the motor's sense, so that the carrier may turn backwards here
  Torques torque;  // [-]
};

/// Speeds when `drive.member` turns at drive.driven_speed() and the fixed member is stationary. Eqs. (15) and
/// (16) of gearset/README.md.
/// @throws std::invalid_argument if the driven member is the fixed one, or its speed is not positive and
/// finite
Speeds member_speeds(const PlanetarySet& set, const Drive& drive);

/// Torques that carry the power drive.power through the set without loss. Eq. (17) of gearset/README.md.
/// @throws std::invalid_argument as member_speeds, and if the power is not positive and finite
Torques member_torques(const PlanetarySet& set, const Drive& drive);

}  // namespace orbearing::gearset
