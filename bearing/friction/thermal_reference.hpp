// The thermal reference speed of [ISO15312]: the speed at which a bearing under reference conditions makes as
// much heat as the reference surface of its seats gives off.
//
//   conditions of radial bearings: load 5 % of C_0, oil of 12 mm^2/s at 70 degC, surroundings at 20 degC
//   (1)  A_r = pi B (D + d)
//   (2)  q_r = 0.016 W/mm^2, beyond A_r = 50 000 mm^2 times (A_r/50 000 mm^2)^-0.34
//   (3)  Phi_r = q_r A_r
//
// Conditions were read in [SKF6000], page 108; (1) to (3) are from memory of the standard.
#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/friction/published_torque.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::friction::thermal_reference {

inline constexpr double kLoadShare = 0.05;    // [-]      of C_0, radial
inline constexpr double kViscosity = 12e-6;   // [m^2/s]
inline constexpr double kTemperature = 70.0;  // [degC]

/// Eq. (1) [m^2].
inline double surface(const BearingSize& size) {
  return constants::pi * size.width * (size.outside + size.bore);
}

/// Eqs. (2) and (3): the heat [W] that leaves at reference conditions.
inline double heat(const BearingSize& size) {
  constexpr double density = 0.016e6;  // [W/m^2]
  constexpr double largest = 0.05;     // [m^2]
  const double area = surface(size);
  return density * area * std::pow(std::max(area, largest) / largest, -0.34);
}

}  // namespace orbearing::bearing::friction::thermal_reference
