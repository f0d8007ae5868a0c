// The stiffness matrix of a housing in a file of its own: matrix_of_file() of rows_file.hpp.
#include <fmt/format.h>

#include <sstream>

#include "app/case/rows_file.hpp"
#include "app/case/text_table.hpp"
#include "gearset/spatial/housing_stiffness.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr std::size_t kDirections = gearset::spatial::kSeatDirections;

std::string column_name(std::size_t column) {
  return fmt::format("{}{}", "xyz"[column % kDirections], column / kDirections + 1);
}

/// Reads a table as a matrix; throws TableFault at the first mistake.
class MatrixReader {
 public:
  MatrixReader(const Field& field, std::istream& stream, std::string_view file)
      : field_(field), table_(stream), file_(file) {}

  Entry read() {
    read_head();
    std::vector<TableCell> cells;
    while (table_.next(cells)) read_row(cells);
    table_.require_plain_decimals();
    if (row_count_ != units_.size())
      fail(table_.line(), 1, fmt::format("{} rows of {} columns", row_count_, units_.size()),
           "a square matrix: as many rows as columns");
    require_stiffness();
    return std::move(list_);
  }

 private:
  void read_head() {
    const std::vector<ColumnHead>& heads = table_.heads();
    const std::string names = "names of columns x1, y1, z1, x2, ..., three for each bearing of the carrier";
    if (heads.empty()) fail(1, 1, "no line", "a first line with the " + names);
    for (std::size_t i = 0; i < heads.size(); ++i) {
      const HeaderCell cell = header_cell(heads[i], {column_name(i)});
      const int line = table_.head_line(), column = heads[i].column;
      if (cell.name.empty())
        fail(line, column, fmt::format("the column {}", quote(heads[i].name)),
             fmt::format("{} in a first line with the {}", column_name(i), names));
      if (cell.unit.empty())
        fail(line, column, fmt::format("the column {} without a unit", quote(heads[i].name)),
             fmt::format("a unit of stiffness, as in '{}_N_per_mm', or (N/mm) below", column_name(i)));
      units_.push_back(cell.unit);
    }
    if (units_.size() % kDirections != 0 || units_.size() > most_matrix_rows)
      fail(table_.head_line(), heads.back().column, fmt::format("{} columns", units_.size()),
           fmt::format("three for each bearing of the carrier, {} at most", most_matrix_rows));
  }

  void read_row(const std::vector<TableCell>& cells) {
    if (++row_count_ > units_.size())
      fail(table_.line(), 1, fmt::format("more rows than the {} columns", units_.size()),
           "a square matrix: as many rows as columns");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string text = table_.number_text(cells[i]) + " " + units_[i];
      const Reading<double> value = read_quantity(text, field_.dimension);
      if (!value.value)
        fail(table_.line(), cells[i].column, fmt::format("{}: {}", quote(text), value.fault), "a stiffness");
      values_.push_back(*value.value);
      list_.items.push_back(make_scalar(text, false, {false, table_.line(), cells[i].column, file_}));
    }
  }

  void require_stiffness() const {
    const auto fault = gearset::spatial::housing_fault(gearset::spatial::matrix_of_rows(values_));
    if (!fault) return;
    const std::size_t at =
        static_cast<std::size_t>(fault->row) * units_.size() + static_cast<std::size_t>(fault->column);
    const Location& location = list_.items[at].location;
    fail(location.line, location.column, fault->found, fault->required);
  }

  const Field& field_;
  TextTable table_;
  std::string_view file_;
  std::vector<std::string> units_;
  std::size_t row_count_ = 0;
  std::vector<double> values_;  // [SI]
  Entry list_ = make_entry(Entry::Shape::list, {false, 1, 1, file_});
};

}  // namespace

Entry matrix_of_file(const Field& field, const Entry& block, const std::string& path,
                     const std::string& case_file, std::vector<Mistake>& mistakes) {
  const auto file = file_of_block(field, block, path, case_file, mistakes);
  if (!file) return {};
  const std::string_view name = lasting(file->name);
  std::istringstream stream(file->text);
  try {
    return MatrixReader(field, stream, name).read();
  } catch (const TableFault& fault) {
    mistakes.push_back({{false, fault.line, fault.column, name},
                        path,
                        {fault.message.found, fault.message.required + " is required"}});
    return {};
  }
}

}  // namespace orbearing::app
