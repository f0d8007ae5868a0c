// The shafts of a case of several sets: from their texts to an arrangement, and what is wrong with it.
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"
#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::app {

/// The arrangement that the case states; of a case of one set, that set with the motor on input.member and
/// the ground on gearset.fixed. What its shafts name must exist.
gearset::Arrangement arrangement_of(const ResolvedCase& resolved);

/// Appends a mistake for each shaft that names no member, and for each reason why speeds or torques do not
/// follow; the latter only where teeth and shafts are whole. For cases of several sets.
void check_arrangement(CheckedCase& resolved);

/// Power, speed and where they enter, with the speed of the motor by kinematics where the case states that of
/// another member. For one of several sets by ResolvedCase::of_set() input.speed is the speed of the motor.
gearset::Drive drive_of(const ResolvedCase& resolved);

/// Adds mistakes for the speed of a stationary member, of one member among several sets, and for the torque
/// of a planet.
void check_speed_of(CheckedCase& resolved);

}  // namespace orbearing::app
