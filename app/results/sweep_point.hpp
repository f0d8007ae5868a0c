// One point of a sweep before it is computed.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "app/case/setting.hpp"

namespace orbearing::app {

struct SweepPoint {
  std::string label;  // for messages: "input.speed = 6000 rpm"
  double input_speed =
      std::numeric_limits<double>::quiet_NaN();                 // [rad/s]  kept in the row of a failed point
  std::vector<double> axis_values;                              // one per header.axes, in the axis' unit
  std::vector<Setting> settings{};                              // that make the case's operating point
};

}  // namespace orbearing::app
