// Speeds, torques and power of every member at a case's operating point, and whether power circulates.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// A member's part in the flow of power. Torque is external, from the shaft on the member; power is positive
/// where it enters the set.
struct PowerRow {
  std::string set;     // "gearset" in a case of one set
  std::string member;  // sun, ring, carrier
  std::string shaft;
  double speed = 0.0;   // [rad/s]
  double torque = 0.0;  // [N m]
  double power = 0.0;   // [W]
  double share = 0.0;   // [-]  of the input power
};

struct PowerTable {
  std::vector<PowerRow> rows;
  double largest_share = 0.0;            // [-]  of the input power, carried by one member
  std::vector<std::string> circulating;  // members that carry more than the input: "main.sun"
};

/// For a sound case of the model planetary-drivetrain.
PowerTable power_table(const ResolvedCase& resolved);

/// `power_flow: [{set, member, shaft, speed_rpm, torque_N_m, power_W, share}]` and `power_circulation:
/// {present, largest_share, members}`.
void describe(described::Record& record, const PowerTable& table);

}  // namespace orbearing::app
