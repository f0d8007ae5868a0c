// A drawing made of characters, for terminals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace orbearing::app {

enum class Glyphs { braille, ascii };

/// Dots on a grid, counted from the lower left corner; a braille character holds 2 by 4 of them.
class Canvas {
 public:
  Canvas(int columns, int lines, Glyphs glyphs);

  int width() const { return columns_ * dots_across(); }  // [dots]
  int height() const { return lines_ * dots_up(); }       // [dots]

  /// Places outside are left out.
  void dot(int x, int y);
  void line(int x0, int y0, int x1, int y1);
  /// A character in place of the dots around (x, y); drawn over everything.
  void mark(int x, int y, const std::string& character);

  /// Lines from the top down.
  std::vector<std::string> lines() const;

 private:
  int dots_across() const { return glyphs_ == Glyphs::braille ? 2 : 1; }
  int dots_up() const { return glyphs_ == Glyphs::braille ? 4 : 1; }
  bool holds(int x, int y) const { return x >= 0 && x < width() && y >= 0 && y < height(); }
  std::size_t cell(int x, int y) const;
  std::string text(std::size_t cell) const;

  int columns_;
  int lines_;
  Glyphs glyphs_;
  std::vector<unsigned> dots_;      // (cells)  bits of the dots set
  std::vector<std::string> marks_;  // (cells)  empty: none
};

}  // namespace orbearing::app
