#include "app/results/terminal_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace orbearing::app {
namespace {

constexpr std::size_t most_rows = 48;  // shown; about a screen

/// Columns shown besides the swept axes, which a planet bearing's life hangs on.
const std::vector<std::string>& main_columns() {
  static const std::vector<std::string> names = {
      "input_speed_rpm",  "carrier_speed_rpm", "planet_load_N",   "centrifugal_load_N",
      "inner_load_max_N", "outer_load_max_N",  "inner_life_Mrev", "outer_life_Mrev",
      "life_h",           "system_life_h"};
  return names;
}

/// Columns with their unit on a line below: "planet_load_N" is "planet load" over "[N]".
std::pair<std::string, std::string> heading(const std::string& name) {
  const std::size_t unit = name.rfind('_');
  std::string words = name.substr(0, unit);
  std::replace(words.begin(), words.end(), '_', ' ');
  return {words, unit == std::string::npos ? "" : "[" + name.substr(unit + 1) + "]"};
}

std::vector<std::string> shown_columns(const TableHead& head) {
  std::vector<std::string> names = main_columns();
  const auto axes = head.names.begin() + static_cast<std::ptrdiff_t>(head.first_axis);
  names.insert(names.begin() + 1, axes, axes + static_cast<std::ptrdiff_t>(head.axes));
  return names;
}

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  return std::abs(value) >= 1000.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

}  // namespace

std::string sweep_table(const TableHead& head, const std::vector<ResultRow>& rows) {
  const std::vector<std::string> names = shown_columns(head);
  const auto width = [](const std::string& name) {
    return std::max<std::size_t>(heading(name).first.size(), 8);
  };
  std::string words;
  std::string units;
  for (const std::string& name : names) {
    words += fmt::format("{:>{}}  ", heading(name).first, width(name));
    units += fmt::format("{:>{}}  ", heading(name).second, width(name));
  }
  const std::string last = head.set_place ? "limiting set: status\n" : "status\n";
  std::string text = words + last + units + '\n';
  const std::size_t step = (rows.size() + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < rows.size(); i += step) {
    for (const std::string& name : names)
      text += fmt::format("{:>{}}  ", number(value_of(head, rows[i], name)), width(name));
    text += (rows[i].limiting_set.empty() ? "" : rows[i].limiting_set + ": ") + rows[i].status + '\n';
  }
  if (step > 1)
    text += fmt::format("(one row in {} of {}; all of them stand in sweep.csv)\n", step, rows.size());
  return text;
}

}  // namespace orbearing::app
