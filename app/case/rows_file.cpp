#include "app/case/rows_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <sstream>

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

std::vector<std::string> keys_of(const Field& field) {
  std::vector<std::string> keys;
  for (const ListColumn& column : field.columns) keys.push_back(column_key(column));
  return keys;
}

bool has_unit(const Field& field, const std::string& key) {
  return std::any_of(field.columns.begin(), field.columns.end(), [&](const ListColumn& column) {
    return column_key(column) == key && !column.dimension.si.empty();
  });
}

// Places in it outlive the reader.
std::string_view lasting(const std::string& name) {
  static std::set<std::string> names;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  return *names.insert(name).first;
}

/// A file of rows, line by line.
class RowsReader {
 public:
  RowsReader(const Field& field, std::string path, const std::string& file, std::vector<Mistake>& mistakes)
      : field_(field), path_(std::move(path)), file_(lasting(file)), mistakes_(mistakes) {}

  Entry read(std::istream& stream) {
    Entry list = make_entry(Entry::Shape::list, location(1, 1));
    std::string line;
    while (next_csv_line(stream, line, line_)) {
      if (const auto fault = text_fault(line)) {
        add_error(fault->column, fault->message.found, fault->message.required + " is required");
        return {};
      }
      if (header_.empty()) {
        if (!read_header(line)) return {};
        continue;
      }
      if (list.items.size() == most_file_rows) {
        add_error(1, fmt::format("more than {} rows", most_file_rows), "a shorter list is required");
        return {};
      }
      if (!read_line(line, list)) return {};
    }
    if (list.items.empty()) add_error(1, "no rows", required());
    return list;
  }

 private:
  Location location(int line, int column) const { return {false, line, column, file_}; }

  std::string required() const {
    return fmt::format(
        "a first line with the names {}, their units behind them, as in '{}_{}', and a row below is required",
        fmt::join(keys_of(field_), ", "), column_key(field_.columns.front()),
        field_.columns.front().dimension.customary);
  }

  void add_error(int column, std::string found, std::string required) {
    mistakes_.push_back({location(line_, column), path_, {std::move(found), std::move(required)}});
  }

  bool read_header(const std::string& line) {
    std::vector<int> columns;
    const std::vector<std::string> cells = csv_cells(line, columns);
    for (const std::string& cell : cells) header_.push_back(header_cell(cell, keys_of(field_)));
    const bool none =
        std::all_of(header_.begin(), header_.end(), [](const HeaderCell& cell) { return cell.name.empty(); });
    if (none || is_of_semicolons(cells)) {
      add_error(1, unknown_head(line), required());
      return false;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (header_[i].name.empty() || (!header_[i].unit.empty() && !takes_unit(header_[i]))) {
        add_error(columns[i], fmt::format("the column {}", quote(cells[i])), required());
        return false;
      }
    }
    return true;
  }

  // A column whose name says the unit may repeat it: hours, hours_h.
  bool takes_unit(const HeaderCell& cell) const { return has_unit(field_, cell.name); }

  bool read_line(const std::string& line, Entry& list) {
    std::vector<int> columns;
    const std::vector<std::string> cells = csv_cells(line, columns);
    if (auto fault = row_fault(cells, columns, header_.size())) {
      add_error(fault->column, fault->message.found, fault->message.required + ", are required");
      return false;
    }
    Entry row = make_entry(Entry::Shape::block, location(line_, 1));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string text = header_[i].unit.empty() ? cells[i] : cells[i] + " " + header_[i].unit;
      const Location here = location(line_, columns[i]);
      row.members.push_back({header_[i].name, here, make_scalar(text, false, here)});
    }
    list.items.push_back(std::move(row));
    return true;
  }

  const Field& field_;
  std::string path_;
  std::string_view file_;
  std::vector<Mistake>& mistakes_;
  std::vector<HeaderCell> header_;
  int line_ = 0;
};

// From the case's folder; what an option names and is not there, from where the command was given.
fs::path found_file(const std::string& name, const std::string& case_file, bool option) {
  const fs::path beside = fs::path(case_file).parent_path() / name;
  std::error_code ignored;
  return option && !fs::exists(beside, ignored) && fs::exists(name, ignored) ? fs::path(name) : beside;
}

}  // namespace

HeaderCell header_cell(const std::string& text, const std::vector<std::string>& names) {
  HeaderCell cell;
  for (const std::string& name : names)
    if (text.starts_with(name) && name.size() > cell.name.size() &&
        (text.size() == name.size() ||
         std::string_view("_ [(").find(text[name.size()]) != std::string_view::npos))
      cell.name = name;
  if (cell.name.empty()) return cell;
  cell.unit = text.substr(cell.name.size());
  const bool underscores = cell.unit.starts_with('_');
  for (const char c : {'_', '[', ']', '(', ')'})
    if (!underscores || c != '_') std::erase(cell.unit, c);
  if (underscores) {
    cell.unit.erase(0, 1);
    replace_all(cell.unit, "_per_", "/");
    replace_all(cell.unit, "per_", "1/");
    replace_all(cell.unit, "_", ".");
  }
  cell.unit = trimmed(cell.unit);
  replace_all(cell.unit, " ", ".");
  return cell;
}

std::vector<std::string> csv_cells(const std::string& line, std::vector<int>& columns) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t first = std::min(line.find_first_not_of(" \t", begin), line.size());
    columns.push_back(static_cast<int>(first) + 1);
    const bool quoted = first < line.size() && line[first] == '"';
    const std::size_t closing = quoted ? line.find('"', first + 1) : first;
    const std::size_t end = line.find(',', std::min(closing, line.size()));
    std::string cell = trimmed(line.substr(begin, end == std::string::npos ? end : end - begin));
    if (quoted && cell.size() > 1 && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(std::move(cell));
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

bool next_csv_line(std::istream& stream, std::string& line, int& number) {
  while (++number, std::getline(stream, line)) {
    if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line[first] != '#') return true;
  }
  return false;
}

namespace {

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// "1500" and "5" of "1500,5": whole numbers, the second without a sign.
bool are_halves(std::string_view whole, std::string_view decimals) {
  whole.remove_prefix(whole.starts_with('-') || whole.starts_with('+') ? 1 : 0);
  return all_digits(whole) && all_digits(decimals.substr(0, decimals.find_first_of("eE")));
}

}  // namespace

std::optional<RowFault> row_fault(const std::vector<std::string>& cells, const std::vector<int>& locations,
                                  std::size_t columns) {
  if (cells.size() == columns) return std::nullopt;
  RowFault fault{1,
                 {fmt::format("{} values", cells.size()),
                  fmt::format("{}, one for each column of the first line", columns)}};
  if (cells.size() < columns) return fault;
  fault.column = locations[columns];
  std::size_t halves = 0;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i)
    if (are_halves(cells[i], cells[i + 1])) {
      ++halves;
      ++i;
    }
  // Where one value has a decimal point, no comma is one.
  const bool points = std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return cell.find('.') != std::string::npos;
  });
  if (!points && halves >= cells.size() - columns)
    fault.message.found +=
        " (a decimal comma splits a number in two: commas separate values here, decimals follow a point)";
  return fault;
}

std::optional<RowFault> text_fault(const std::string& line) {
  if (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff"))
    return RowFault{1, {"a file in UTF-16", "a text file in UTF-8 (save it as UTF-8)"}};
  const std::size_t byte = first_byte_not_utf8(line);
  if (byte == line.size()) return std::nullopt;
  return RowFault{static_cast<int>(byte) + 1, {"a byte that is not UTF-8", "a text file in UTF-8"}};
}

bool is_of_semicolons(const std::vector<std::string>& cells) {
  return cells.size() == 1 && cells.front().find(';') != std::string::npos;
}

std::string unknown_head(const std::string& line) {
  const std::string none = "a first line that names none of these columns";
  if (line.find(';') != std::string::npos && line.find(',') == std::string::npos)
    return none + " (semicolons in it: commas separate columns here, and decimals follow a point)";
  return none;
}

std::optional<NamedFile> read_named_file(const std::string& name, const Location& named,
                                         const std::string& path, const std::string& case_file,
                                         std::vector<Mistake>& mistakes) {
  const fs::path file = found_file(name, case_file, named.option);
  const auto none = [&](const std::string& found, std::string required) {
    mistakes.push_back({named, path, {"the file " + quote(file.string()) + found, std::move(required)}});
    return std::nullopt;
  };
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return none(", which is not there or no file", "a CSV file is required");
  if (fs::file_size(file, error) > largest_rows_file)
    return none(" of more than 4 MiB", "a shorter one is required");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return none(", which cannot be opened", "a CSV file is required");
  return NamedFile{file.string(), {std::istreambuf_iterator<char>(stream), {}}};
}

Entry rows_of_text(const Field& field, const std::string& text, const std::string& path,
                   const std::string& file, std::vector<Mistake>& mistakes) {
  std::istringstream stream(text);
  return RowsReader(field, path, file, mistakes).read(stream);
}

Entry rows_of_file(const Field& field, const Entry& block, const std::string& path,
                   const std::string& case_file, std::vector<Mistake>& mistakes) {
  const Member* named = find_member(block, "file");
  if (named == nullptr || block.members.size() != 1 || named->value.shape != Entry::Shape::scalar ||
      trimmed(named->value.text).empty()) {
    mistakes.push_back({block.location, path, {"a block", requirement(field) + " is required"}});
    return {};
  }
  const auto file = read_named_file(named->value.text, block.location, path, case_file, mistakes);
  return file ? rows_of_text(field, file->text, path, file->name, mistakes) : Entry{};
}

}  // namespace orbearing::app
