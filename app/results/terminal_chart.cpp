#include "app/results/terminal_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace orbearing::app {
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
    const double life = life_to_go_by(head, row);
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

}  // namespace orbearing::app
