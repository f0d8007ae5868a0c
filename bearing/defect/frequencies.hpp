// Frequencies at which the parts of a bearing pass each other at pure rolling.
#pragma once

#include "bearing/parameters.hpp"

namespace orbearing::bearing::defect {

struct PassingFrequencies {
  double shaft = 0.0;         // [Hz]  of the inner ring against the outer one
  double cage = 0.0;          // [Hz]
  double outer_pass = 0.0;    // [Hz]  elements over a place of the outer race
  double inner_pass = 0.0;    // [Hz]  elements over a place of the inner race
  double element_pass = 0.0;  // [Hz]  a place of an element over either race: twice its spin in the cage
};

/// Speed at which an element rolls about its own axis in the frame of the cage [rad/s], at pure rolling
/// without spin; positive the way the races of faster outer rings turn it. The axis of a ball that touches
/// its races under an angle is across the line of its contacts: eq. (6).
double rolling_speed(const Bearing& bearing, double inner_speed, double outer_speed);

/// At `shaft_speed` [rad/s] of the inner ring; the outer one stands.
PassingFrequencies passing_frequencies(const Bearing& bearing, double shaft_speed);
/// At the speeds [rad/s] of both rings, as a planet's bearing has them relative to the carrier: 0 of the pin
/// and that of the planet. The cage's is relative to the same frame.
PassingFrequencies passing_frequencies(const Bearing& bearing, double inner_speed, double outer_speed);

}  // namespace orbearing::bearing::defect
