// Tables of text as programs and spreadsheets write them: a line of names, perhaps a line of units, rows.
//
//     time_s,speed_rpm,torque_N_m       Zeit [s];Drehzahl [rpm];Moment [N m]       Time   RotSpeed   RotTorq
//     0.0,1500.5,1591.25                0,0;1500,5;1591,25                         (s)    (rpm)      (kN-m)
//                                                                                  0.0    12.10      3946.0
//
// Columns are separated by commas, semicolons, tabs or blanks, which the line of names shows. Decimals follow
// a point or, where commas do not separate columns or quotes enclose the number, a comma. A table in which
// numbers have two possible readings is refused. Text is UTF-8, UTF-16 with its byte order mark, or Latin-1
// (ISO 8859-1).
#pragma once

#include <deque>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/case/mistake.hpp"

namespace orbearing::app {

/// A mistake at its place in a table, counted from 1 in bytes of UTF-8. Thrown by the reader.
struct TableFault {
  int line = 1;
  int column = 1;
  ConsistencyMessage message;
};

[[noreturn]] inline void fail(int line, int column, std::string found, std::string required) {
  throw TableFault{line, column, {std::move(found), std::move(required)}};
}

struct TableCell {
  std::string text;  // without blanks around it and without quotes
  int column = 1;    // of its first character
};

/// A column's name and its unit, as written: "kN-m" of "(kN-m)". The unit is empty where no line of units
/// holds one.
struct ColumnHead {
  std::string name;
  std::string unit;
  int line = 1;
  int column = 1;
};

/// Names and units for a message, the first of many.
std::string columns_text(const std::vector<ColumnHead>& heads);

/// Cells of a line; quotes may enclose one. Blanks as `separator` separate in any number.
std::vector<TableCell> split_cells(const std::string& line, char separator);

/// Whether a decimal comma of which commas separate columns can have split numbers in two.
bool splits_decimal_commas(const std::vector<TableCell>& cells, std::size_t columns);

class TextTable {
 public:
  /// Reads up to the names of the columns. Lines that are empty or begin with # are passed over, but for
  /// names (and units in brackets below them) that a # precedes directly above the rows; so are lines before
  /// the names where a line of units in brackets is below them, as OpenFAST writes both. Throws TableFault.
  explicit TextTable(std::istream& stream);

  const std::vector<ColumnHead>& heads() const { return heads_; }  // none: the file holds no line
  int head_line() const { return head_line_; }

  /// The next row, of as many cells as there are heads; false at the end. Throws TableFault for another
  /// number of cells, and for text that cannot be decoded.
  bool next(std::vector<TableCell>& cells);
  int line() const { return line_; }  // of the last row; behind the last line at the end

  /// The text of a cell that holds a number, with a decimal point. Throws TableFault where commas and points
  /// together leave a doubt.
  std::string number_text(const TableCell& cell);
  /// To be called behind the last row: throws TableFault where all numbers with a point, or a comma, can be
  /// read with and without decimals ("1.500": 1.5 or 1500).
  void require_plain_decimals() const;

  /// Names and units of the columns, for a message; empty where the file is no table of numbers, whose
  /// content is not shown.
  std::string shown_heads();

  /// Warnings on text that is not UTF-8: how it was read.
  std::vector<std::string> warnings() const;

 private:
  struct Line {
    std::string text;
    int number = 0;
  };
  /// The first number with this mark of decimals, and whether one of them can have no other reading.
  struct Marks {
    int line = 0;
    int column = 0;
    std::string text{};
    bool sure = false;
  };

  bool read_line(Line& line);
  bool take_names_of_comment(const std::vector<TableCell>& cells, std::optional<char> stated);
  bool look_ahead(std::size_t lines);
  bool take_line(Line& line);
  void decode(Line& line);
  void find_head();
  void take_units();

  std::istream* stream_;
  std::string utf16_;  // of a file in UTF-16, as UTF-8
  std::size_t utf16_position_ = 0;
  bool is_utf16_ = false;
  std::deque<Line> ahead_;
  std::deque<Line> comments_;  // the last two before the first line that is none, without their #
  std::vector<ColumnHead> heads_;
  char separator_ = ',';
  int read_ = 0;  // lines of the file
  int head_line_ = 1;
  int line_ = 1;
  int utf8_line_ = 0;    // the first that holds a character of UTF-8 beyond ASCII; 0: none
  int latin1_line_ = 0;  // the first that is no UTF-8
  Marks points_, commas_;
};

}  // namespace orbearing::app
