// Speeds, torques and power of the members of a drivetrain, and whether power circulates.
#pragma once

#include <optional>

#include "gearset/drivetrain/power_flow.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// A drivetrain of one or several sets at its operating point.
struct PowerOfMembers {
  gearset::Arrangement arrangement;
  gearset::PowerFlow flow;
  double speed = 0.0;  // [rad/s]  of the motor
  double power = 0.0;  // [W]
};

PowerOfMembers power_of_members(const gearset::Arrangement& arrangement, const gearset::Drive& drive);

/// Torque is external, from the shaft on the member; power is positive where it enters the set.
/// `power_flow: [{set, member, shaft, speed_rpm, torque_N_m, power_W, share}]` and `power_circulation:
/// {present, largest_share, members}`.
void describe(described::Record& record, const PowerOfMembers& of);

/// Load and overall ratio of a drivetrain with parallel stages.
struct OverallRatio {
  double load_speed = 0.0;  // [rpm]  so that round speeds stay round
  double ratio = 0.0;       // [-]  of the load to the motor
};
/// None without parallel stages: then the ratio is that of the sets.
std::optional<OverallRatio> overall_ratio(const gearset::Arrangement& arrangement,
                                          const gearset::Drive& drive);
void describe(described::Record& record, const OverallRatio& of);

}  // namespace orbearing::analysis
