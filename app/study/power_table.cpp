#include "app/study/power_table.hpp"

#include "app/case/arrangement_case.hpp"
#include "gearset/drivetrain/power_flow.hpp"

namespace orbearing::app {

PowerTable power_table(const ResolvedCase& resolved) {
  const gearset::Arrangement arrangement = arrangement_of(resolved);
  const gearset::PowerFlow flow = gearset::power_flow(arrangement);
  const double speed = resolved.quantity("input.speed");
  const double power = resolved.quantity("input.power");
  PowerTable table;
  for (const gearset::MemberFlow& member : flow.members)
    table.rows.push_back(
        {.set = arrangement.sets[member.member.set].name,
         .member = gearset::member_word(arrangement.sets[member.member.set], member.member.member),
         .shaft = arrangement.shafts[member.shaft].name,
         .speed = speed * member.speed,
         .torque = power / speed * member.torque,
         .power = power * member.power,
         .share = member.power});
  const gearset::PowerCirculation circulation = gearset::power_circulation(flow);
  table.largest_share = circulation.largest_share;
  for (const gearset::SetMember& member : circulation.members)
    table.circulating.push_back(name_of(arrangement, member));
  return table;
}

void describe(described::Record& row, const PowerRow& member) {
  using namespace described;
  row.value("set", "of gears", member.set);
  row.value("member", "of the set", member.member);
  row.value("shaft", "that carries it", member.shaft);
  row.value("speed_rpm", dimension::angular_speed, "of the member", member.speed);
  row.value("torque_N_m", dimension::torque, "from the shaft on the member", member.torque);
  row.value("power_W", dimension::heat, "positive where it enters the set", member.power);
  row.value("share", dimension::ratio, "of the input power", member.share);
}

void describe(described::Record& record, const PowerTable& table) {
  using namespace described;
  record.table("power_flow", "member", "speeds, torques and power of all members", table.rows);
  record.child("power_circulation", "members that carry more than the input", table,
               [](Record& circulation, const PowerTable& of) {
                 circulation.value("present", "whether power circulates", !of.circulating.empty());
                 circulation.value("largest_share", dimension::ratio,
                                   "of the input power, carried by one member", of.largest_share);
                 circulation.value("members", "that carry more than the input", of.circulating);
               });
}

}  // namespace orbearing::app
