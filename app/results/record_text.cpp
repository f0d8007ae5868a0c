#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"

namespace orbearing::app {

namespace {

using described::Numbers;

constexpr std::size_t kNumbersInLine = 12;
constexpr std::size_t kMatrix = 8;        // rows and columns at most, that have lines of their own
constexpr std::size_t kAlignedText = 24;  // letters at most of a text that others are aligned with
constexpr std::size_t kWidest = 160;      // letters of a line

/// A name and its value as text or number: numbers of an array with labels have a name each.
struct Cell {
  std::string name{};
  std::string unit{};
  std::string meaning{};
  std::optional<double> number{};
  std::string text{};
  std::vector<std::string> items{};  // of a list of texts
  described::NumberKind kind = described::NumberKind::real;
};

std::string shown(const Cell& cell) {
  if (!cell.number) return cell.text;
  if (!std::isfinite(*cell.number)) return "-";
  if (cell.kind == described::NumberKind::real) return fmt::format("{:.6g}", *cell.number);
  return cell.kind == described::NumberKind::whole ? fmt::format("{:.0f}", *cell.number)
                                                   : fmt::format("{}", *cell.number != 0.0);
}

std::string unit_of(const described::Entry& entry) {
  return entry.dimension.customary == "1" ? std::string() : std::string(entry.dimension.customary);
}

std::string list_text(const described::Entry& entry, const Numbers& numbers) {
  std::vector<double> values;
  for (const double value : numbers.values) values.push_back(in_customary_unit(entry.dimension, value));
  if (values.size() <= kNumbersInLine) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : " ") + shown({.number = value});
    return text;
  }
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return "-";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} values, {:.6g} to {:.6g}", numbers.values.size(), *least, *most);
}

// More numbers than a line holds.
bool is_matrix(const Numbers& numbers) {
  return numbers.shape.size() == 2 && numbers.values.size() > kNumbersInLine &&
         std::ranges::max(numbers.shape) <= kMatrix;
}

void add_numbers(const described::Entry& entry, const Numbers& numbers, const std::string& name,
                 std::vector<Cell>& cells) {
  const bool labelled = numbers.shape.size() == 1 && !numbers.along[0].labels.empty();
  if (!labelled && !numbers.shape.empty()) {
    cells.push_back({name, unit_of(entry), entry.meaning, std::nullopt, list_text(entry, numbers)});
    return;
  }
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    const std::string label = labelled ? numbers.along[0].labels[i] : "";
    cells.push_back({.name = label.empty() || name.empty() ? name + label : name + "." + label,
                     .unit = unit_of(entry),
                     .meaning = entry.meaning,
                     .number = in_customary_unit(entry.dimension, numbers.values[i]),
                     .kind = numbers.kind});
  }
}

// Cells of all entries but tables and matrices; those of a structure have its name as a prefix.
void add_cells(const Record& record, const std::string& prefix, std::vector<Cell>& cells) {
  for (const described::Entry& entry : record.entries()) {
    if (entry.in_files_alone || entry.detail) continue;
    const std::string name = prefix + entry.name;
    if (const auto* numbers = std::get_if<Numbers>(&entry.content);
        numbers != nullptr && !is_matrix(*numbers))
      add_numbers(entry, *numbers, name, cells);
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      add_cells(child->one.front(), name + ".", cells);
    const auto add = [&](std::string text) {
      cells.push_back({name, "", entry.meaning, std::nullopt, std::move(text)});
    };
    if (const auto* text = std::get_if<std::string>(&entry.content)) add(*text);
    if (const auto* texts = std::get_if<described::Texts>(&entry.content)) {
      add(fmt::format("{}", fmt::join(*texts, ", ")));
      cells.back().items = *texts;
    }
  }
}

std::vector<Cell> cells_of(const Record& record) {
  std::vector<Cell> cells;
  add_cells(record, "", cells);
  return cells;
}

/// Rows of cells under the names that any of them has; missing ones are empty.
struct Grid {
  std::vector<std::string> names;
  std::vector<std::vector<Cell>> rows;
};

Grid grid_of(const described::Table& table) {
  Grid grid;
  std::map<std::string, std::size_t> columns;
  for (const Record& record : table.rows) {
    std::vector<Cell>& row = grid.rows.emplace_back(grid.names.size());
    for (Cell& cell : cells_of(record)) {
      const auto [column, added] = columns.try_emplace(cell.name, grid.names.size());
      if (added) grid.names.push_back(cell.name);
      if (added) row.emplace_back();
      row[column->second] = std::move(cell);
    }
  }
  for (std::vector<Cell>& row : grid.rows) row.resize(grid.names.size());
  return grid;
}

using Texts = std::vector<std::vector<std::string>>;  // columns, each with its name first

Texts transposed(const Texts& columns) {
  Texts rows(columns.front().size());
  for (const std::vector<std::string>& column : columns)
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(column[i]);
  return rows;
}

std::size_t width_of(const std::vector<std::string>& column) {
  return std::ranges::max(column, {}, &std::string::size).size();
}

// Numbers to the right, texts to the left.
std::vector<std::string> lines_of(const Texts& columns) {
  std::vector<std::string> lines(columns.front().size());
  for (const std::vector<std::string>& column : columns) {
    const auto known =
        std::find_if(column.begin() + 1, column.end(), [](const auto& cell) { return cell != "-"; });
    const bool numbers = known != column.end() && known->find_first_of("0123456789") <= 1;
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines[i] += numbers ? fmt::format("  {:>{}}", column[i], width_of(column))
                          : fmt::format("  {:<{}}", column[i], width_of(column));
  }
  return lines;
}

std::string lines_text(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  return text;
}

// A table of many values and few rows has a line for each value.
std::string table_text(const std::string& title, const described::Table& table) {
  const Grid grid = grid_of(table);
  Texts columns;
  for (std::size_t i = 0; i < grid.names.size(); ++i) {
    columns.push_back({grid.names[i]});
    for (const std::vector<Cell>& row : grid.rows) columns.back().push_back(shown(row[i]));
  }
  std::vector<std::string> lines = lines_of(columns);
  if (lines.front().size() > kWidest && grid.rows.size() < grid.names.size())
    lines = lines_of(transposed(columns));
  return "\n" + title + "\n" + lines_text(lines);
}

std::string title_of(const std::string& name, const described::Entry& entry) {
  return entry.meaning.empty() ? name : name + ": " + entry.meaning;
}

// Text of an entry that is a matrix, named after `prefix`; empty for any other one.
std::string matrix_text(const std::string& prefix, const described::Entry& entry) {
  const auto* numbers = std::get_if<Numbers>(&entry.content);
  if (numbers == nullptr || !is_matrix(*numbers)) return "";
  const auto label = [&](std::size_t dimension, std::size_t i) {
    const std::vector<std::string>& labels = numbers->along[dimension].labels;
    return labels.empty() ? std::to_string(i + 1) : labels[i];
  };
  const std::size_t width = numbers->shape[1];
  Texts columns(1 + width);
  columns[0].emplace_back();
  for (std::size_t row = 0; row < numbers->shape[0]; ++row) columns[0].push_back(label(0, row));
  for (std::size_t column = 0; column < width; ++column) {
    std::vector<std::string>& cells = columns[1 + column];
    cells.push_back(label(1, column));
    for (std::size_t row = 0; row < numbers->shape[0]; ++row)
      cells.push_back(
          shown({.number = in_customary_unit(entry.dimension, numbers->values[row * width + column])}));
  }
  return "\n" + title_of(prefix + entry.name, entry) + "\n" + lines_text(lines_of(columns));
}

// Matrices of all rows, named by the number of their row in the table.
std::string matrices_text(const std::string& name, const described::Table& table) {
  std::string text;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (const described::Entry& entry : table.rows[row].entries())
      text += matrix_text(fmt::format("{}.{}.", name, row + 1), entry);
  return text;
}

std::string tables_text(const Record& record, const std::string& prefix) {
  std::string text;
  for (const described::Entry& entry : record.entries()) {
    if (entry.in_files_alone || entry.detail) continue;
    text += matrix_text(prefix, entry);
    if (const auto* table = std::get_if<described::Table>(&entry.content);
        table != nullptr && !table->rows.empty())
      text += table_text(title_of(prefix + entry.name, entry), *table) +
              matrices_text(prefix + entry.name, *table);
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      text += tables_text(child->one.front(), prefix + entry.name + ".");
  }
  return text;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

namespace {

std::string in_csv(const Cell& cell) {
  if (!cell.number) return csv_field(cell.text);
  if (!std::isfinite(*cell.number)) return "";
  return cell.kind == described::NumberKind::real ? fmt::format("{}", *cell.number) : shown(cell);
}

template <class Items, class Field>
std::string csv_line(const Items& items, const Field& field) {
  std::string line;
  for (const auto& item : items) line += field(item) + ",";
  line.back() = '\n';  // instead of the last comma
  return line;
}

// Index in `numbers` of the element of `whole` at `location`.
std::size_t location_in(const Numbers& numbers, const Numbers& whole, std::size_t location) {
  std::vector<std::size_t> at(whole.shape.size());
  for (std::size_t i = at.size(); i-- > 0; location /= whole.shape[i]) at[i] = location % whole.shape[i];
  std::size_t found = 0;
  for (std::size_t i = 0; i < numbers.shape.size(); ++i)
    for (std::size_t k = 0; k < at.size(); ++k)
      if (whole.along[k].name == numbers.along[i].name) found = found * numbers.shape[i] + at[k];
  return found;
}

std::string csv_of_arrays(const Record& arrays) {
  const std::vector<described::Entry>& columns = arrays.entries();
  const auto numbers_of = [](const described::Entry& column) -> const Numbers& {
    return std::get<Numbers>(column.content);
  };
  const Numbers& whole = numbers_of(*std::ranges::max_element(
      columns, {}, [&](const described::Entry& column) { return numbers_of(column).values.size(); }));
  std::string text = csv_line(columns, [](const described::Entry& column) { return csv_field(column.name); });
  for (std::size_t row = 0; row < whole.values.size(); ++row)
    text += csv_line(columns, [&](const described::Entry& column) {
      const Numbers& numbers = numbers_of(column);
      return in_csv(
          {.number = in_customary_unit(column.dimension, numbers.values[location_in(numbers, whole, row)])});
    });
  return text;
}

}  // namespace

namespace {

bool is_long_list(const Cell& cell) {
  return !cell.items.empty() && cell.text.size() > kWidest;
}

// In lines of their own, behind the tables.
std::string long_list_text(const Cell& cell) {
  std::string text = fmt::format("\n{}: {}\n ", cell.name, cell.meaning);
  std::size_t width = 1;
  for (std::size_t i = 0; i < cell.items.size(); ++i) {
    const std::string item = cell.items[i] + (i + 1 < cell.items.size() ? "," : "");
    if (width > 1 && width + 1 + item.size() > kWidest) {
      text += "\n ";
      width = 1;
    }
    text += " " + item;
    width += 1 + item.size();
  }
  return text + "\n";
}

}  // namespace

std::string text_of(const Record& record) {
  std::vector<Cell> cells = cells_of(record);
  std::string long_lists;
  for (const Cell& cell : cells)
    if (is_long_list(cell)) long_lists += long_list_text(cell);
  std::erase_if(cells, is_long_list);
  std::size_t names = 0, values = 0, units = 0;
  for (const Cell& cell : cells) {
    names = std::max(names, cell.name.size());
    if (const std::size_t size = shown(cell).size(); cell.number || size <= kAlignedText)
      values = std::max(values, size);
    units = std::max(units, cell.unit.size());
  }
  std::vector<std::string> lines;
  for (const Cell& cell : cells)
    lines.push_back(fmt::format("{:<{}}  {:>{}} {:<{}}  {}", cell.name, names, shown(cell), values, cell.unit,
                                units, cell.meaning));
  return lines_text(lines) + tables_text(record, "") + long_lists;
}

std::string csv_names(const Record& record) {
  return csv_line(record.entries(), [](const described::Entry& entry) { return csv_field(entry.name); });
}

std::string csv_values(const Record& record) {
  return csv_line(record.entries(), [](const described::Entry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.content)) return csv_field(*text);
    const Numbers& numbers = std::get<Numbers>(entry.content);
    return in_csv(
        {.number = in_customary_unit(entry.dimension, numbers.values.front()), .kind = numbers.kind});
  });
}

std::string csv_of(const described::Entry& table) {
  if (const auto* arrays = std::get_if<described::Child>(&table.content))
    return csv_of_arrays(arrays->one.front());
  const Grid grid = grid_of(std::get<described::Table>(table.content));
  std::string text = csv_line(grid.names, [](const std::string& name) { return csv_field(name); });
  for (const std::vector<Cell>& row : grid.rows) text += csv_line(row, in_csv);
  return text;
}

}  // namespace orbearing::app
