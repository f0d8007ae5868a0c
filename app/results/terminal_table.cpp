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

/// "2 x P1 at 6063 rpm": harmonic, mode, speed.
std::string resonance_text(const TableHead& head, const ResultRow& row) {
  if (row.resonance_mode.empty()) return "-";
  return fmt::format("{:g} x {} at {:.0f} rpm", value_of(head, row, "resonance_harmonic"), row.resonance_mode,
                     value_of(head, row, "resonance_speed_rpm"));
}

/// The rows that are shown, and what a last line says of the others.
struct ShownRows {
  std::vector<const ResultRow*> rows;
  std::string note;
};

/// All of a few; else the grid's every so many-th and, of the points added to it, the one that lives longest.
ShownRows shown_rows(const TableHead& head, const std::vector<ResultRow>& rows) {
  ShownRows shown;
  const ResultRow* longest = nullptr;
  double life = 0.0;
  std::size_t grid = 0, added = 0;
  for (const ResultRow& row : rows) {
    ++(row.refined ? added : grid);
    if (!(life_to_go_by(head, row) > life)) continue;
    life = life_to_go_by(head, row);
    longest = &row;
  }
  const bool all = rows.size() <= most_rows;
  const std::size_t step = all ? 1 : (grid + most_rows - 1) / most_rows;
  std::size_t location = 0;
  for (const ResultRow& row : rows) {
    const bool of_grid = !row.refined && location++ % step == 0;
    if (of_grid || (row.refined && (all || &row == longest))) shown.rows.push_back(&row);
  }
  if (step > 1) shown.note = fmt::format("one row in {} of {}", step, grid);
  if (const std::size_t hidden = added - (longest != nullptr && longest->refined ? 1 : 0); !all && hidden > 0)
    shown.note +=
        fmt::format("{}{} points added around the peak are not shown", step > 1 ? "; " : "", hidden);
  return shown;
}

}  // namespace

std::string sweep_table(const TableHead& head, const std::vector<ResultRow>& rows) {
  constexpr int resonance_width = 20;
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
  if (head.first_resonance) words += fmt::format("{:<{}}  ", "nearest resonance", resonance_width);
  const std::string last = head.set_place ? "limiting set: status\n" : "status\n";
  std::string text = words + last + units + '\n';
  const ShownRows shown = shown_rows(head, rows);
  for (const ResultRow* row : shown.rows) {
    for (const std::string& name : names)
      text += fmt::format("{:>{}}  ", number(value_of(head, *row, name)), width(name));
    if (head.first_resonance) text += fmt::format("{:<{}}  ", resonance_text(head, *row), resonance_width);
    text += (row->limiting_set.empty() ? "" : row->limiting_set + ": ") + row->status;
    text += row->refined ? ", added\n" : "\n";
  }
  if (!shown.note.empty()) text += fmt::format("({}; all of them stand in sweep.csv)\n", shown.note);
  return text;
}

}  // namespace orbearing::app
