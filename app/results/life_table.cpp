#include "app/results/life_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace orbearing::app {

namespace {

std::string life_number_text(double value) {
  if (std::isinf(value)) return "no load";
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "-";
}

// "C 48417 N, C0 ...": what has no number is left out.
std::string listed(const LifeValue& value, const std::vector<described::Entry>& entries) {
  std::string text;
  for (const described::Entry& entry : entries)
    if (const double found = value(entry.name); std::isfinite(found))
      text += fmt::format("{}{} {:.5g}{}{}", text.empty() ? "" : ", ", entry.symbol, found,
                          entry.dimension.customary == "1" ? "" : " ",
                          entry.dimension.customary == "1" ? "" : entry.dimension.customary);
  return text.empty() ? "" : text + "\n";
}

}  // namespace

std::string lives_text(const LifeTable& table) {
  const LifeValue& value = table.value;
  std::string text = fmt::format("{:<20} {:>12} {:>12}  {}\n", "life of one bearing", "[h]", "[Mrev]", "by");
  for (const analysis::LifeLine& line : analysis::life_lines(table.words))
    text += fmt::format("{:<20} {:>12} {:>12}  {}\n", line.hours, life_number_text(value(line.hours)),
                        life_number_text(value(line.revolutions)), line.by);
  const std::vector<described::Entry> loads = analysis::load_entries();
  const auto ratios = std::ranges::find_if(loads, [](const auto& entry) { return entry.name == "C_over_P"; });
  return text + listed(value, {loads.begin(), ratios}) + listed(value, {ratios, loads.end()}) +
         design_advice(table);
}

}  // namespace orbearing::app
