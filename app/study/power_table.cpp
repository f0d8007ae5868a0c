#include "app/study/power_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/case/arrangement_case.hpp"
#include "app/results/result_row.hpp"
#include "app/units.hpp"
#include "gearset/drivetrain/power_flow.hpp"

namespace orbearing::app {

namespace {}  // namespace

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

std::string power_text(const PowerTable& table) {
  std::size_t widest = 6;
  for (const PowerRow& row : table.rows) widest = std::max({widest, row.set.size(), row.shaft.size()});
  std::string text =
      fmt::format("{:{}}  {:<8} {:{}}  {:>12} {:>12} {:>12}  {}\n", "set", widest, "member", "shaft", widest,
                  "speed [rpm]", "torque [N.m]", "power [kW]", "share of input");
  for (const PowerRow& row : table.rows)
    text +=
        fmt::format("{:{}}  {:<8} {:{}}  {:>12.6g} {:>12.6g} {:>12.6g}  {:.4g}\n", row.set, widest,
                    row.member, row.shaft, widest, kRpm * row.speed, row.torque, 1e-3 * row.power, row.share);
  if (table.circulating.empty()) return text + "power does not circulate\n";
  return text + fmt::format("power circulates: {} carry more than the input, up to {:.4g} times\n",
                            fmt::join(table.circulating, ", "), table.largest_share);
}

nlohmann::ordered_json power_json(const PowerTable& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const PowerRow& row : table.rows)
    rows.push_back({{"set", row.set},
                    {"member", row.member},
                    {"shaft", row.shaft},
                    {"speed_rpm", in_table_unit(row.speed, kRpm)},
                    {"torque_N_m", row.torque},
                    {"power_W", row.power},
                    {"share", row.share}});
  return {{"power_flow", rows},
          {"power_circulation",
           {{"present", !table.circulating.empty()},
            {"largest_share", table.largest_share},
            {"members", table.circulating}}}};
}

}  // namespace orbearing::app
