// Speeds, torques and power of every member of an arrangement, per unit of what the motor gives: all are
// linear in its speed and torque.
#pragma once

#include <vector>

#include "gearset/drivetrain/arrangement.hpp"
#include "gearset/kinematics.hpp"

namespace orbearing::gearset {

/// Share of one member in the flow of power. Ratios are to the motor's speed, torque and power.
struct MemberFlow {
  SetMember member;
  std::size_t shaft = 0;
  double speed = 0.0;   // [-]  of the member, positive in the motor's sense
  double torque = 0.0;  // [-]  external, from its shaft on the member
  double power = 0.0;   // [-]  that enters the set by this member; negative where it leaves
};

/// Share of one shaft, from what acts on it besides the sets: motor, load and ground together.
struct ShaftFlow {
  double speed = 0.0;   // [-]
  double torque = 0.0;  // [-]  from outside
  double power = 0.0;   // [-]  positive where it enters
};

struct PowerFlow {
  std::vector<MemberRatios> sets;   // speeds and torques of each set's members, per unit of the motor's
  std::vector<MemberFlow> members;  // sun, ring, carrier of each set in turn
  std::vector<ShaftFlow> shafts;
};

/// Solves Eqs. (26) to (30) of gearset/README.md.
/// @throws std::invalid_argument with the first of `arrangement_problems`
PowerFlow power_flow(const Arrangement& arrangement);

/// Power that goes round in a circle loads members beyond what is put in.
struct PowerCirculation {
  double largest_share = 0.0;      // [-]  of the input power, carried by one member
  std::vector<SetMember> members;  // that carry more than the input; none: power does not circulate

  bool present() const { return !members.empty(); }
};

PowerCirculation power_circulation(const PowerFlow& flow);

/// Sets that transmit no torque, as those of an automatic gearbox of which a brake or clutch is open: their
/// members turn with what they are joined to.
std::vector<std::size_t> idle_sets(const PowerFlow& flow);

/// One set as an arrangement of its own: motor, load and ground on a member each.
/// @throws std::invalid_argument if the driven member is the fixed one
Arrangement arrangement_of(const PlanetarySet& set, Member driven, const std::string& name);

}  // namespace orbearing::gearset
