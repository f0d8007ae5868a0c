#include "coupling/analysis/power_of_members.hpp"

#include <algorithm>

#include "mechanics/constants.hpp"

namespace orbearing::analysis {

using described::each;
using described::Record;
namespace dimension = described::dimension;

PowerOfMembers power_of_members(const gearset::Arrangement& arrangement, const gearset::Drive& drive) {
  return {arrangement, gearset::power_flow(arrangement), drive.motor_speed(), drive.power};
}

void describe(Record& record, const PowerOfMembers& in) {
  const gearset::Arrangement& arrangement = in.arrangement;
  const gearset::PowerFlow& flow = in.flow;
  const double speed = in.speed, power = in.power;
  record.table("power_flow", "member", "speeds, torques and power of all members", flow.members,
               [&](Record& row, const gearset::MemberFlow& of) {
                 const gearset::ArrangedSet& set = arrangement.sets[of.member.set];
                 row.value("set", "of gears", set.name);
                 row.value("member", "of the set", gearset::member_word(set, of.member.member));
                 row.value("shaft", "that carries it", arrangement.shafts[of.shaft].name);
                 row.value("speed_rpm", dimension::angular_speed, "of the member", speed * of.speed);
                 row.value("torque_N_m", dimension::torque, "from the shaft on the member",
                           power / speed * of.torque);
                 row.value("power_W", dimension::heat, "positive where it enters the set", power * of.power);
                 row.value("share", dimension::ratio, "of the input power", of.power);
               });
  if (const std::vector<std::size_t> idle = gearset::idle_sets(flow); !idle.empty())
    record.value("idle_sets", "that transmit no torque",
                 each(idle, [&](std::size_t set) { return arrangement.sets[set].name; }));
  record.child(
      "power_circulation", "members that carry more than the input", gearset::power_circulation(flow),
      [&](Record& circulation, const gearset::PowerCirculation& of) {
        circulation.value("present", "whether power circulates", of.present());
        circulation.value("largest_share", dimension::ratio,
                          "of the input power, carried by one member; without losses, which act on all that "
                          "circulates and so change torques by that many times their share",
                          of.largest_share);
        circulation.value(
            "members", "that carry more than the input",
            each(of.members, [&](const gearset::SetMember& member) { return name_of(arrangement, member); }));
      });
}

std::optional<OverallRatio> overall_ratio(const gearset::Arrangement& arrangement,
                                          const gearset::Drive& drive) {
  if (std::ranges::none_of(arrangement.sets, &gearset::ArrangedSet::is_parallel)) return std::nullopt;
  const auto load = std::ranges::find_if(arrangement.shafts, &gearset::Shaft::load);
  const gearset::ShaftFlow flow =
      gearset::power_flow(arrangement).shafts.at(static_cast<std::size_t>(load - arrangement.shafts.begin()));
  return OverallRatio{30.0 / constants::pi * flow.speed * drive.motor_speed(), flow.speed};
}

void describe(Record& record, const OverallRatio& of) {
  constexpr described::Dimension in_rpm{"angular speed", "rpm", "rpm", ""};
  record.value("operation.load_speed_rpm", in_rpm,
               "of the shaft by which the power leaves, behind all stages", of.load_speed);
  record.value("operation.overall_ratio", dimension::ratio,
               "speed of the load over that of the motor, all stages; negative: against it", of.ratio);
}

}  // namespace orbearing::analysis
