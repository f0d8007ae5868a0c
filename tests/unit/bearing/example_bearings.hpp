// Bearings and motions that several tests share.
#pragma once

#include <cmath>

#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::example_bearings {

/// Planet bearing of the reduction set, Table 2 of [Gai2025], with its cage in glass-filled polyamide.
inline Bearing planet_bearing() {
  Bearing bearing;
  bearing.rollers().count = 15;
  bearing.rollers().diameter = 5.24e-3;
  bearing.rollers().length = 5.7e-3;
  bearing.pitch_diameter = 35.64e-3;
  bearing.inner.seat_diameter = 25e-3;
  bearing.outer.seat_diameter = 47e-3;
  bearing.width = 11.9e-3;
  bearing.cage = {.inner_diameter = 33.44e-3, .outer_diameter = 38.54e-3, .width = 9e-3, .density = 1310.0};
  return bearing;
}

/// Cylindrical roller bearing 209 of the worked examples in [Harris2006].
inline Bearing bearing_209() {
  Bearing bearing;
  bearing.rollers().count = 14;
  bearing.rollers().diameter = 10e-3;
  bearing.rollers().length = 9.6e-3;
  bearing.pitch_diameter = 65e-3;
  return bearing;
}

/// A bearing in a housing: load [N] along the angle `direction` [rad], nothing turns.
inline OperatingPoint static_load(double load, double direction = 0.0) {
  OperatingPoint point;
  point.bore_load = load * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  return point;
}

/// Kinematics of the reduction set (37/22/79 teeth, sun drives, stationary ring) at `sun_speed` [rad/s].
inline OperatingPoint planet_motion(double sun_speed) {
  OperatingPoint point;
  point.carrier = {.speed = sun_speed / (1.0 + 79.0 / 37.0), .acceleration = 0.0, .orbit_radius = 87.891e-3};
  point.outer_speed = -(sun_speed - point.carrier.speed) * 37.0 / 22.0;
  return point;
}

/// [rad/s] from revolutions per minute.
inline double rpm(double revolutions_per_minute) {
  return revolutions_per_minute * constants::two_pi / 60.0;
}

}  // namespace orbearing::bearing::example_bearings
