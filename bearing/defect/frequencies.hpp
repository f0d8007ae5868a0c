// Frequencies at which the parts of a bearing pass each other at pure rolling.
#pragma once

#include "bearing/parameters.hpp"

namespace orbearing::bearing::defect {

/// The outer ring stands.
struct PassingFrequencies {
  double shaft = 0.0;         // [Hz]
  double cage = 0.0;          // [Hz]
  double outer_pass = 0.0;    // [Hz]  elements over a place of the outer race
  double inner_pass = 0.0;    // [Hz]  elements over a place of the inner race
  double element_pass = 0.0;  // [Hz]  a place of an element over either race: twice its spin in the cage
};

/// At `shaft_speed` [rad/s] of the inner ring.
PassingFrequencies passing_frequencies(const Bearing& bearing, double shaft_speed);

}  // namespace orbearing::bearing::defect
