// Speeds that change in time: a run-up in which all speeds keep their ratios. Angles integrate in closed
// form, so that the state needs no more variables.
//
//   s = 1 + ramp t,   speed = s * speed(0),   angle = speed(0) * (t + ramp t^2 / 2),   W' = ramp W(0)
//
#pragma once

#include "bearing/motion/parameters.hpp"

namespace orbearing::bearing::motion {

/// All speeds at `time` [s] over those at t = 0: s.
inline double speed_ratio(const Driving& driving, double time) {
  return 1.0 + driving.ramp * time;
}

/// Forces of the meshes at `time` [s] over those at t = 0: they pass constant power.
inline double mesh_ratio(const Driving& driving, double time) {
  return 1.0 / speed_ratio(driving, time);
}

/// Time [s] in which the speeds of t = 0 would give the angles turned by `time` [s].
inline double equivalent_time(const Driving& driving, double time) {
  return time + 0.5 * driving.ramp * time * time;
}

}  // namespace orbearing::bearing::motion
