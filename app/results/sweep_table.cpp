#include "app/results/sweep_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/results/worst_bearing.hpp"

namespace orbearing::app {

namespace {

// "life", or the name of another that results go by.
std::string name_of_life(const LifePeak& peak) {
  return peak.life == "life_h" ? "life" : peak.life;
}

// "longest life: 47300 h at 6120 rpm; of the grid's points 47100 h at 6000 rpm"
std::string peak_line(const LifePeak& peak) {
  const std::string longest = "longest " + name_of_life(peak) + ": ";
  if (!std::isfinite(peak.life_h)) return longest + "no point has one\n";
  if (!std::isfinite(peak.refined_life_h))
    return longest + fmt::format("{:.5g} h at {:g} rpm\n", peak.life_h, peak.speed_rpm);
  std::string line =
      longest + fmt::format("{:.5g} h at {:g} rpm", peak.refined_life_h, peak.refined_speed_rpm);
  if (peak.refined_speed_rpm != peak.speed_rpm)
    line += fmt::format("; of the grid's points {:.5g} h at {:g} rpm", peak.life_h, peak.speed_rpm);
  return line + '\n';
}

}  // namespace

std::string peak_text(const ManifestHeader& header, const std::vector<SweepRow>& rows, const LifePeak& peak) {
  const auto without = std::ranges::count_if(rows, [&](const SweepRow& row) {
    return !std::isfinite(row.point.input_speed) || !(governing_hours(header, row.point) > 0.0);
  });
  return (without > 0 ? fmt::format("{} of {} points have no life\n", without, rows.size()) : "") +
         peak_line(peak);
}

namespace {

constexpr std::size_t most_rows = 48;  // shown; about a screen

/// Columns shown besides the swept axes: what affects the life of a planet bearing, and the life that results
/// go by.
std::vector<std::string> main_columns(const std::string& life) {
  return {"input_speed_rpm",    "carrier_speed_rpm", "planet_load_N",
          "centrifugal_load_N", "inner_load_max_N",  "outer_load_max_N",
          "inner_life_Mrev",    "outer_life_Mrev",   life,
          "system_" + life};
}

/// Columns with their unit on a line below: "planet_load_N" is "planet load" over "[N]", "L10mh" is in hours.
std::pair<std::string, std::string> heading(const std::string& name) {
  const std::size_t unit = name.rfind('_');
  if (name.find("L10") != std::string::npos && name.ends_with('h'))
    return {unit == std::string::npos ? name : "system " + name.substr(unit + 1), "[h]"};
  std::string words = name.substr(0, unit);
  std::replace(words.begin(), words.end(), '_', ' ');
  return {words, unit == std::string::npos ? "" : "[" + name.substr(unit + 1) + "]"};
}

std::vector<std::string> shown_columns(const ManifestHeader& header) {
  std::vector<std::string> names = main_columns(header.life);
  const std::vector<std::string> axes = described::each(header.axes, &SweptAxis::column);
  names.insert(names.begin() + 1, axes.begin(), axes.end());
  return names;
}

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  return std::abs(value) >= 1000.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

/// "2 x P1 at 6063 rpm": harmonic, mode, speed.
std::string resonance_text(const SweepRow& row) {
  if (!row.resonance) return "-";
  return fmt::format("{} x {} at {:.0f} rpm", row.resonance->harmonic, row.resonance->mode,
                     speed_in_rpm(row.resonance->speed));
}

/// The rows that are shown, and the text on the others for a last line.
struct ShownRows {
  std::vector<const SweepRow*> rows;
  std::string note;
};

/// All rows of a few; else every n-th of the grid and, of the points added to it, the one with the longest
/// life.
ShownRows shown_rows(const ManifestHeader& header, const std::vector<SweepRow>& rows) {
  ShownRows shown;
  const SweepRow* longest = longest_lived(header, rows);
  std::size_t grid = 0, added = 0;
  for (const SweepRow& row : rows) ++(row.refined ? added : grid);
  const bool all = rows.size() <= most_rows;
  const std::size_t step = all ? 1 : (grid + most_rows - 1) / most_rows;
  std::size_t location = 0;
  for (const SweepRow& row : rows) {
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

std::string sets_table(const ManifestHeader& header, const SweepRow& row) {
  const std::vector<std::string>& sets = header.sets;
  if (sets.empty() || !row.ok()) return "";
  const auto value = [&](const std::string& set, const std::string& name) {
    return number_named(header, row, column_prefix(set) + name);
  };
  std::size_t set_width = std::string_view("set").size();
  for (const std::string& set : sets) set_width = std::max(set_width, set.size());
  std::vector<std::string> lines{fmt::format("{:<{}}", "set", set_width)};
  for (const std::string& set : sets) lines.push_back(fmt::format("{:<{}}", set, set_width));
  for (const auto& [name, words] :
       std::array<std::pair<std::string, std::string>, 7>{{{"planet_load_N", "planet load [N]"},
                                                           {header.life, header.life + " [h]"},
                                                           {"shortest_" + header.life, "shortest [h]"},
                                                           {"S0", "S0"},
                                                           {"kappa", "kappa"},
                                                           {"contact_pressure_max_MPa", "pressure [MPa]"},
                                                           {"largest_load_share", "load share"}}}) {
    if (std::ranges::none_of(sets,
                             [&, &name = name](const auto& set) { return std::isfinite(value(set, name)); }))
      continue;
    const std::size_t width = std::max<std::size_t>(words.size(), 8);
    lines.front() += fmt::format("  {:>{}}", words, width);
    for (std::size_t i = 0; i < sets.size(); ++i)
      lines[i + 1] += fmt::format("  {:>{}}", number(value(sets[i], name)), width);
  }
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (sets[i] == row.point.limiting_set) lines[i + 1] += "  limiting set: it has the worst bearing";
  return fmt::format("{}\n\n", fmt::join(lines, "\n"));
}

std::string sweep_table(const ManifestHeader& header, const std::vector<SweepRow>& rows) {
  constexpr int resonance_width = 20;
  constexpr std::string_view heading_of_sets = "limiting set";
  const std::vector<std::string> names = shown_columns(header);
  const auto width = [](const std::string& name) {
    return std::max<std::size_t>(heading(name).first.size(), 8);
  };
  std::string words;
  std::string units;
  for (const std::string& name : names) {
    words += fmt::format("{:>{}}  ", heading(name).first, width(name));
    units += fmt::format("{:>{}}  ", heading(name).second, width(name));
  }
  if (header.resonances) words += fmt::format("{:<{}}  ", "nearest resonance", resonance_width);
  const ShownRows shown = shown_rows(header, rows);
  std::size_t set_width = header.sets.empty() ? 0 : heading_of_sets.size();
  for (const SweepRow* row : shown.rows) set_width = std::max(set_width, row->point.limiting_set.size());
  if (!header.sets.empty()) words += fmt::format("{:<{}}  ", heading_of_sets, set_width);
  std::string text = words + "status\n" + units + '\n';
  for (const SweepRow* row : shown.rows) {
    for (const std::string& name : names)
      text += fmt::format("{:>{}}  ", number(number_named(header, *row, name)), width(name));
    if (header.resonances) text += fmt::format("{:<{}}  ", resonance_text(*row), resonance_width);
    if (!header.sets.empty()) text += fmt::format("{:<{}}  ", row->point.limiting_set, set_width);
    text += row->point.status;
    text += row->refined ? ", added\n" : "\n";
  }
  if (!shown.note.empty()) text += fmt::format("({}; all of them stand in sweep.csv)\n", shown.note);
  return text;
}

}  // namespace orbearing::app
