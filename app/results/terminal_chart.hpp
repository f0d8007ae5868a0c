// A small chart of life over speed, for terminals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/results/result_row.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

// A drawing made of characters, for terminals.

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
  /// A character instead of the dots around (x, y); drawn over everything.
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

/// Braille where the locale's character set is UTF-8 (LC_ALL, LC_CTYPE, LANG, in this order).
Glyphs glyphs_of_locale();

/// Life [h], logarithmic, over input speed [rpm], axes labelled, the peak marked and written in a line below.
/// Points without a life are left out and counted. Fewer than two speeds give the line alone.
std::string life_chart(const TableHead& head, const std::vector<ResultRow>& rows, const LifePeak& peak,
                       Glyphs glyphs);

// The main columns of a sweep, for terminals.

/// Speed, planet load, largest roller loads, lives and the swept axes, aligned; a failed point shows its
/// status, and whether the point was added to the grid. Of a long sweep every n-th row of the grid and the
/// longest life, with a last line that states this.
std::string sweep_table(const TableHead& head, const std::vector<ResultRow>& rows);

/// Loads, lives, safety and pressure of each of several sets at one point; nothing of one set.
std::string sets_table(const TableHead& head, const std::vector<std::string>& sets, const ResultRow& row);

}  // namespace orbearing::app
