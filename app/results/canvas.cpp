#include "app/results/canvas.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

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

}  // namespace orbearing::app
