#include "app/results/terminal_chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "app/results/worst_bearing.hpp"

namespace orbearing::app {

namespace {

/// Bits of Unicode's braille patterns by column and by dot from the bottom.
constexpr std::array<std::array<unsigned, 4>, 2> braille_bits = {
    {{0x40, 0x04, 0x02, 0x01}, {0x80, 0x20, 0x10, 0x08}}};

/// U+2800 plus `bits` in UTF-8.
std::string braille(unsigned bits) {
  return {static_cast<char>(0xE2), static_cast<char>(0xA0 + (bits >> 6U)),
          static_cast<char>(0x80 + (bits & 0x3FU))};
}

}  // namespace

Canvas::Canvas(int columns, int lines, Glyphs glyphs)
    : columns_(columns),
      lines_(lines),
      glyphs_(glyphs),
      dots_(static_cast<std::size_t>(columns * lines), 0U),
      marks_(dots_.size()) {}

std::size_t Canvas::cell(int x, int y) const {
  const int line_from_top = lines_ - 1 - y / dots_up();
  return static_cast<std::size_t>(line_from_top * columns_ + x / dots_across());
}

void Canvas::dot(int x, int y) {
  if (!holds(x, y)) return;
  const auto across = static_cast<std::size_t>(x % dots_across());
  const auto up = static_cast<std::size_t>(y % dots_up());
  dots_[cell(x, y)] |= braille_bits[across][up];
}

void Canvas::line(int x0, int y0, int x1, int y1) {
  const int steps = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
  for (int i = 0; i <= steps; ++i)
    dot(x0 + ((x1 - x0) * i * 2 + steps) / (2 * steps), y0 + ((y1 - y0) * i * 2 + steps) / (2 * steps));
}

void Canvas::mark(int x, int y, const std::string& character) {
  if (holds(x, y)) marks_[cell(x, y)] = character;
}

std::string Canvas::text(std::size_t cell) const {
  if (!marks_[cell].empty()) return marks_[cell];
  if (dots_[cell] == 0) return " ";
  return glyphs_ == Glyphs::braille ? braille(dots_[cell]) : ".";
}

std::vector<std::string> Canvas::lines() const {
  std::vector<std::string> result(static_cast<std::size_t>(lines_));
  for (std::size_t i = 0; i < dots_.size(); ++i) result[i / static_cast<std::size_t>(columns_)] += text(i);
  return result;
}

namespace {

constexpr int columns = 64;
constexpr int lines = 14;
constexpr int label_width = 9;  // characters left of the vertical axis

struct Curve {
  std::vector<double> speed;  // [rpm]
  std::vector<double> life;   // [h]
};

/// A linear map of values onto the dots 0 to `last`.
struct Scale {
  double low = 0.0;
  double high = 1.0;
  int last = 1;
  int location(double value) const {
    return static_cast<int>(std::lround((value - low) / (high - low) * last));
  }
};

Curve curve_of(const TableHead& head, const std::vector<ResultRow>& rows) {
  Curve curve;
  for (const ResultRow& row : rows) {
    const double speed = value_of(head, row, "input_speed_rpm");
    const double life = governing_life_in(head, row);
    if (!std::isfinite(speed) || !(life > 0.0)) continue;
    curve.speed.push_back(speed);
    curve.life.push_back(life);
  }
  return curve;
}

/// A little wider than the values; never empty.
Scale scale_of(const std::vector<double>& values, double least_width, int last) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double margin = std::max(0.0, (least_width - (*largest - *least)) / 2.0);
  return {*least - margin, *largest + margin, last};
}

/// 1, 2 or 5 times a power of ten, so that `width` holds about `count` of it.
double round_step(double width, int count) {
  const double rough = width / count;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= rough) return factor * decade;
  return 10.0 * decade;
}

/// Round values of a logarithmic axis; where it spans little, those of a plain one.
std::vector<double> life_ticks(const Scale& scale) {
  std::vector<double> ticks;
  for (double exponent = std::floor(scale.low); exponent <= scale.high; exponent += 1.0)
    for (const double factor : {1.0, 2.0, 5.0}) ticks.push_back(factor * std::pow(10.0, exponent));
  const auto outside = [&](double tick) {
    return std::log10(tick) < scale.low || std::log10(tick) > scale.high;
  };
  std::erase_if(ticks, outside);
  if (ticks.size() >= 2) return ticks;
  ticks.clear();
  const double least = std::pow(10.0, scale.low);
  const double largest = std::pow(10.0, scale.high);
  const double step = round_step(largest - least, 3);
  for (double tick = std::ceil(least / step) * step; tick <= largest; tick += step) ticks.push_back(tick);
  return ticks;
}

/// Consecutive points of rising speed are joined; another swept axis starts a new line.
void draw(Canvas& canvas, const Curve& curve, const Scale& across, const Scale& up) {
  for (std::size_t i = 0; i < curve.speed.size(); ++i) {
    const int x = across.location(curve.speed[i]);
    const int y = up.location(std::log10(curve.life[i]));
    canvas.dot(x, y);
    if (i > 0 && curve.speed[i] > curve.speed[i - 1])
      canvas.line(across.location(curve.speed[i - 1]), up.location(std::log10(curve.life[i - 1])), x, y);
  }
}

// "life", or the name of another that results go by.
std::string name_of_life(const LifePeak& peak) {
  return peak.life == "life_h" ? "life" : peak.life;
}

std::string with_life_axis(const Canvas& canvas, const Scale& up, const std::string& life, Glyphs glyphs) {
  std::vector<std::string> labels(lines);
  for (const double tick : life_ticks(up)) {
    const int line = lines - 1 - up.location(std::log10(tick)) * lines / canvas.height();
    labels[static_cast<std::size_t>(std::clamp(line, 0, lines - 1))] = fmt::format("{:.7g}", tick);
  }
  std::string text = fmt::format("{:>{}}\n", life + " [h]", label_width);
  const std::vector<std::string> drawn = canvas.lines();
  const bool plain = glyphs == Glyphs::ascii;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const char* axis = labels[i].empty() ? (plain ? "|" : "│") : (plain ? "+" : "┤");
    text += fmt::format("{:>{}} {}{}\n", labels[i], label_width, axis, drawn[i]);
  }
  return text;
}

std::string speed_axis(const Scale& across, int dots_per_column, Glyphs glyphs) {
  std::vector<std::string> axis(columns, glyphs == Glyphs::ascii ? "-" : "─");
  std::string labels;
  const double step = round_step(across.high - across.low, 6);
  for (double tick = std::ceil(across.low / step) * step; tick <= across.high; tick += step) {
    const int column = across.location(tick) / dots_per_column;
    axis[static_cast<std::size_t>(column)] = glyphs == Glyphs::ascii ? "+" : "┬";
    const std::string label = fmt::format("{:g}", tick);
    const int start = std::max(0, column - static_cast<int>(label.size()) / 2);
    if (!labels.empty() && start <= static_cast<int>(labels.size())) continue;
    labels += std::string(static_cast<std::size_t>(start) - labels.size(), ' ') + label;
  }
  const std::string corner = glyphs == Glyphs::ascii ? "+" : "└";
  return fmt::format("{:>{}} {}{}\n{:>{}}  {}  [rpm]\n", "", label_width, corner, fmt::join(axis, ""), "",
                     label_width, labels);
}

std::string drawing(const Curve& curve, const LifePeak& peak, Glyphs glyphs) {
  Canvas canvas(columns, lines, glyphs);
  std::vector<double> exponents;
  for (const double life : curve.life) exponents.push_back(std::log10(life));
  const Scale across = scale_of(curve.speed, 0.0, canvas.width() - 1);
  constexpr double least_decades = 0.05;
  const Scale up = scale_of(exponents, least_decades, canvas.height() - 1);
  draw(canvas, curve, across, up);
  const bool refined = std::isfinite(peak.refined_life_h);
  const double peak_rpm = refined ? peak.refined_speed_rpm : peak.speed_rpm;
  const double peak_life = refined ? peak.refined_life_h : peak.life_h;
  if (peak_life > 0.0)
    canvas.mark(across.location(peak_rpm), up.location(std::log10(peak_life)),
                glyphs == Glyphs::ascii ? "O" : "●");
  return with_life_axis(canvas, up, name_of_life(peak), glyphs) +
         speed_axis(across, canvas.width() / columns, glyphs);
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

Glyphs glyphs_of_locale() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    std::string locale = value;
    std::transform(locale.begin(), locale.end(), locale.begin(), [](unsigned char c) {
      return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    const bool utf8 = locale.find("utf-8") != std::string::npos || locale.find("utf8") != std::string::npos;
    return utf8 ? Glyphs::braille : Glyphs::ascii;
  }
  return Glyphs::ascii;
}

std::string life_chart(const TableHead& head, const std::vector<ResultRow>& rows, const LifePeak& peak,
                       Glyphs glyphs) {
  const Curve curve = curve_of(head, rows);
  std::string text;
  if (!curve.speed.empty() && scale_of(curve.speed, 0.0, 1).high > scale_of(curve.speed, 0.0, 1).low)
    text = drawing(curve, peak, glyphs);
  if (curve.speed.size() < rows.size())
    text += fmt::format("{} of {} points have no life and are not shown\n", rows.size() - curve.speed.size(),
                        rows.size());
  return text + peak_line(peak);
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

std::vector<std::string> shown_columns(const TableHead& head) {
  std::vector<std::string> names = main_columns(head.life);
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

/// The rows that are shown, and the text on the others for a last line.
struct ShownRows {
  std::vector<const ResultRow*> rows;
  std::string note;
};

/// All rows of a few; else every n-th of the grid and, of the points added to it, the one with the longest
/// life.
ShownRows shown_rows(const TableHead& head, const std::vector<ResultRow>& rows) {
  ShownRows shown;
  const ResultRow* longest = longest_lived(head, rows);
  std::size_t grid = 0, added = 0;
  for (const ResultRow& row : rows) ++(row.refined ? added : grid);
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

std::string sets_table(const TableHead& head, const std::vector<std::string>& sets, const ResultRow& row) {
  if (sets.empty() || !row.ok()) return "";
  const auto value = [&](const std::string& set, const std::string& name) {
    return value_of(head, row, column_prefix(set) + name);
  };
  std::size_t set_width = std::string_view("set").size();
  for (const std::string& set : sets) set_width = std::max(set_width, set.size());
  std::vector<std::string> lines{fmt::format("{:<{}}", "set", set_width)};
  for (const std::string& set : sets) lines.push_back(fmt::format("{:<{}}", set, set_width));
  for (const auto& [name, words] :
       std::array<std::pair<std::string, std::string>, 7>{{{"planet_load_N", "planet load [N]"},
                                                           {head.life, head.life + " [h]"},
                                                           {"shortest_" + head.life, "shortest [h]"},
                                                           {"S0", "S0"},
                                                           {"kappa", "kappa"},
                                                           {"contact_pressure_max_MPa", "pressure [MPa]"},
                                                           {"largest_load_share", "load share"}}}) {
    if (std::ranges::none_of(sets, [&](const auto& set) { return std::isfinite(value(set, name)); }))
      continue;
    const std::size_t width = std::max<std::size_t>(words.size(), 8);
    lines.front() += fmt::format("  {:>{}}", words, width);
    for (std::size_t i = 0; i < sets.size(); ++i)
      lines[i + 1] += fmt::format("  {:>{}}", number(value(sets[i], name)), width);
  }
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (sets[i] == row.limiting_set) lines[i + 1] += "  limiting set: it has the worst bearing";
  return fmt::format("{}\n\n", fmt::join(lines, "\n"));
}

std::string sweep_table(const TableHead& head, const std::vector<ResultRow>& rows) {
  constexpr int resonance_width = 20;
  constexpr std::string_view heading_of_sets = "limiting set";
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
  const ShownRows shown = shown_rows(head, rows);
  std::size_t set_width = head.set_place ? heading_of_sets.size() : 0;
  for (const ResultRow* row : shown.rows) set_width = std::max(set_width, row->limiting_set.size());
  if (head.set_place) words += fmt::format("{:<{}}  ", heading_of_sets, set_width);
  std::string text = words + "status\n" + units + '\n';
  for (const ResultRow* row : shown.rows) {
    for (const std::string& name : names)
      text += fmt::format("{:>{}}  ", number(value_of(head, *row, name)), width(name));
    if (head.first_resonance) text += fmt::format("{:<{}}  ", resonance_text(head, *row), resonance_width);
    if (head.set_place) text += fmt::format("{:<{}}  ", row->limiting_set, set_width);
    text += row->status;
    text += row->refined ? ", added\n" : "\n";
  }
  if (!shown.note.empty()) text += fmt::format("({}; all of them stand in sweep.csv)\n", shown.note);
  return text;
}

}  // namespace orbearing::app
