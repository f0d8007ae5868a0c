// What is wrong with the shafts of a case of several sets, and with the speed that a case states.
#pragma once

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Appends a mistake for each shaft that names no member, and for each reason why speeds or torques do not
/// follow; the latter only where teeth and shafts are whole. For cases of several sets.
void check_arrangement(CheckedCase& resolved);

/// Adds mistakes for the speed of a stationary member, of one member among several sets, and for the torque
/// of a planet.
void check_speed_of(CheckedCase& resolved);

}  // namespace orbearing::app
