#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"
#include "app/results/row_text.hpp"

namespace orbearing::app {

namespace {

using described::Entry;
using described::Numbers;

constexpr std::size_t kNumbersInLine = 12;

/// A name and what stands for its value: numbers of an array with labels have a name each.
struct Cell {
  std::string name;
  std::string unit;
  std::string meaning;
  std::optional<double> number;
  std::string text;
};

std::string shown(const Cell& cell) {
  if (!cell.number) return cell.text;
  return std::isfinite(*cell.number) ? fmt::format("{:.6g}", *cell.number) : "-";
}

std::string unit_of(const Entry& entry) {
  return entry.dimension.customary == "1" ? std::string() : std::string(entry.dimension.customary);
}

std::string list_text(const Entry& entry, const Numbers& numbers) {
  std::vector<double> values;
  for (const double value : numbers.values) values.push_back(in_customary_unit(entry.dimension, value));
  if (values.size() <= kNumbersInLine) {
    std::string text;
    for (const double value : values)
      text += (text.empty() ? "" : " ") +
              shown({.name = {}, .unit = {}, .meaning = {}, .number = value, .text = {}});
    return text;
  }
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return "-";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} values, {:.6g} to {:.6g}", numbers.values.size(), *least, *most);
}

void add_numbers(const Entry& entry, const Numbers& numbers, const std::string& name,
                 std::vector<Cell>& cells) {
  const bool labelled = numbers.shape.size() == 1 && !numbers.along[0].labels.empty();
  if (!labelled && !numbers.shape.empty()) {
    cells.push_back({name, unit_of(entry), entry.meaning, std::nullopt, list_text(entry, numbers)});
    return;
  }
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    const std::string label = labelled ? numbers.along[0].labels[i] : "";
    cells.push_back({label.empty() || name.empty() ? name + label : name + "." + label,
                     unit_of(entry),
                     entry.meaning,
                     in_customary_unit(entry.dimension, numbers.values[i]),
                     {}});
  }
}

// Of all but tables, those of a structure named after it.
void add_cells(const Record& record, const std::string& prefix, std::vector<Cell>& cells) {
  for (const Entry& entry : record.entries()) {
    if (entry.in_files_alone) continue;
    const std::string name = prefix + entry.name;
    if (const auto* numbers = std::get_if<Numbers>(&entry.content)) add_numbers(entry, *numbers, name, cells);
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      add_cells(child->one.front(), name + ".", cells);
    const auto add = [&](std::string text) {
      cells.push_back({name, "", entry.meaning, std::nullopt, std::move(text)});
    };
    if (const auto* text = std::get_if<std::string>(&entry.content)) add(*text);
    if (const auto* flag = std::get_if<bool>(&entry.content)) add(*flag ? "true" : "false");
    if (const auto* count = std::get_if<std::int64_t>(&entry.content)) add(fmt::format("{}", *count));
  }
}

std::vector<Cell> cells_of(const Record& record) {
  std::vector<Cell> cells;
  add_cells(record, "", cells);
  return cells;
}

const Cell* cell_called(const std::vector<Cell>& cells, const std::string& name) {
  const auto found =
      std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) { return cell.name == name; });
  return found == cells.end() ? nullptr : &*found;
}

/// Rows of cells under the names that any of them has.
struct Grid {
  std::vector<std::string> names;
  std::vector<std::vector<Cell>> rows;
};

Grid grid_of(const described::Table& table) {
  Grid grid;
  for (const Record& row : table.rows) {
    grid.rows.push_back(cells_of(row));
    for (const Cell& cell : grid.rows.back())
      if (std::find(grid.names.begin(), grid.names.end(), cell.name) == grid.names.end())
        grid.names.push_back(cell.name);
  }
  return grid;
}

std::string table_text(const std::string& title, const described::Table& table) {
  const Grid grid = grid_of(table);
  std::vector<std::string> lines(grid.rows.size() + 1);
  for (const std::string& name : grid.names) {
    std::vector<std::string> column{name};
    for (const auto& row : grid.rows) {
      const Cell* cell = cell_called(row, name);
      column.push_back(cell == nullptr ? "" : shown(*cell));
    }
    std::size_t width = 0;
    for (const std::string& text : column) width = std::max(width, text.size());
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += fmt::format("  {:>{}}", column[i], width);
  }
  std::string text = "\n" + title + "\n";
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string title_of(const std::string& name, const Entry& entry) {
  return entry.meaning.empty() ? name : name + ": " + entry.meaning;
}

std::string tables_text(const Record& record, const std::string& prefix) {
  std::string text;
  for (const Entry& entry : record.entries()) {
    if (entry.in_files_alone) continue;
    if (const auto* table = std::get_if<described::Table>(&entry.content);
        table != nullptr && !table->rows.empty())
      text += table_text(title_of(prefix + entry.name, entry), *table);
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      text += tables_text(child->one.front(), prefix + entry.name + ".");
  }
  return text;
}

std::string in_csv(const Cell& cell) {
  if (!cell.number) return csv_field(cell.text);
  return std::isfinite(*cell.number) ? fmt::format("{}", *cell.number) : std::string();
}

}  // namespace

std::string text_of(const Record& record) {
  const std::vector<Cell> cells = cells_of(record);
  std::size_t names = 0, values = 0, units = 0;
  for (const Cell& cell : cells) {
    names = std::max(names, cell.name.size());
    values = std::max(values, shown(cell).size());
    units = std::max(units, cell.unit.size());
  }
  std::string text;
  for (const Cell& cell : cells)
    text += fmt::format("{:<{}}  {:>{}} {:<{}}  {}\n", cell.name, names, shown(cell), values, cell.unit,
                        units, cell.meaning);
  return text + tables_text(record, "");
}

std::string csv_of(const described::Table& table) {
  const Grid grid = grid_of(table);
  std::string text;
  const auto end_line = [&text] { text.back() = '\n'; };  // in place of the last comma
  for (const std::string& name : grid.names) text += csv_field(name) + ",";
  end_line();
  for (const std::vector<Cell>& row : grid.rows) {
    for (const std::string& name : grid.names) {
      const Cell* cell = cell_called(row, name);
      text += (cell == nullptr ? "" : in_csv(*cell)) + ",";
    }
    end_line();
  }
  return text;
}

}  // namespace orbearing::app
