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
#include <utility>

#include "app/case/text_parts.hpp"
#include "app/case/text_table.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

// Keys of all columns, or of the columns that each row requires.
std::vector<std::string> column_keys(const Field& field, bool required) {
  std::vector<std::string> keys;
  for (const ListColumn& column : field.columns)
    if (!required || !column.optional) keys.push_back(column_key(column));
  return keys;
}

const ListColumn* column_of(const Field& field, const std::string& key) {
  const auto found = std::find_if(field.columns.begin(), field.columns.end(),
                                  [&](const ListColumn& column) { return column_key(column) == key; });
  return found == field.columns.end() ? nullptr : &*found;
}

/// A file of rows, line by line.
class RowsReader {
 public:
  RowsReader(const Field& field, std::string path, const std::string& file, std::vector<Mistake>& mistakes)
      : field_(field), path_(std::move(path)), file_(lasting(file)), mistakes_(mistakes) {}

  Entry read(std::istream& stream) {
    try {
      TextTable table(stream);
      return read_rows(table);
    } catch (const TableFault& fault) {
      add_error(fault.line, fault.column, fault.message.found, fault.message.required + " is required");
      return {};
    }
  }

 private:
  Location location(int line, int column) const { return {false, line, column, file_}; }

  std::string required() const {
    return fmt::format(
        "a first line with the names {}, their units behind them, as in '{}_{}', and a row below is required",
        fmt::join(column_keys(field_, true), ", "), column_key(field_.columns.front()),
        field_.columns.front().dimension.customary);
  }

  void add_error(int line, int column, std::string found, std::string required) {
    mistakes_.push_back({location(line, column), path_, {std::move(found), std::move(required)}});
  }

  Entry read_rows(TextTable& table) {
    Entry list = make_entry(Entry::Shape::list, location(1, 1));
    if (!table.heads().empty() && !read_head(table)) return {};
    std::vector<TableCell> cells;
    while (table.next(cells)) {
      if (list.items.size() == most_file_rows) {
        add_error(table.line(), 1, fmt::format("more than {} rows", most_file_rows),
                  "a shorter list is required");
        return {};
      }
      list.items.push_back(row_of(table, cells));
    }
    table.require_plain_decimals();
    if (list.items.empty()) add_error(table.line(), 1, "no rows", required());
    return list;
  }

  bool read_head(TextTable& table) {
    const std::vector<ColumnHead>& heads = table.heads();
    for (const ColumnHead& head : heads) header_.push_back(header_cell(head, column_keys(field_, false)));
    if (std::all_of(header_.begin(), header_.end(),
                    [](const HeaderCell& cell) { return cell.name.empty(); })) {
      add_error(table.head_line(), 1, unknown_heads(table),
                required() + "; orbearing spectrum makes such a file of a record over time");
      return false;
    }
    for (std::size_t i = 0; i < heads.size(); ++i) {
      if (header_[i].name.empty() || (!header_[i].unit.empty() && !takes_unit(header_[i]))) {
        add_error(table.head_line(), heads[i].column, fmt::format("the column {}", quote(heads[i].name)),
                  required());
        return false;
      }
    }
    return true;
  }

  // A column whose name has the unit may repeat it: hours, hours_h.
  bool takes_unit(const HeaderCell& cell) const {
    const ListColumn* column = column_of(field_, cell.name);
    return column != nullptr && !column->dimension.si.empty();
  }

  Entry row_of(TextTable& table, const std::vector<TableCell>& cells) const {
    Entry row = make_entry(Entry::Shape::block, location(table.line(), 1));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Location here = location(table.line(), cells[i].column);
      if (column_of(field_, header_[i].name)->text) {
        if (!cells[i].text.empty())
          row.members.push_back({header_[i].name, here, make_scalar(cells[i].text, true, here)});
        continue;
      }
      const std::string number = table.number_text(cells[i]);
      const std::string text = header_[i].unit.empty() ? number : number + " " + header_[i].unit;
      row.members.push_back({header_[i].name, here, make_scalar(text, false, here)});
    }
    return row;
  }

  const Field& field_;
  std::string path_;
  std::string_view file_;
  std::vector<Mistake>& mistakes_;
  std::vector<HeaderCell> header_;
};

// From the case's folder; what an option names and is not there, from where the command was given.
fs::path found_file(const std::string& name, const std::string& case_file, bool option) {
  const fs::path beside = fs::path(case_file).parent_path() / name;
  std::error_code ignored;
  return option && !fs::exists(beside, ignored) && fs::exists(name, ignored) ? fs::path(name) : beside;
}

// The only folder that files may be in, if there is one; an empty name: no folder is.
std::optional<fs::path> only_folder;

thread_local KeptFiles* kept_files = nullptr;

bool may_be_read(const fs::path& file) {
  if (!only_folder) return true;
  if (only_folder->empty()) return false;
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(file, error);
  return !error && std::ranges::mismatch(*only_folder, whole).in1 == only_folder->end();
}

}  // namespace

std::string_view lasting(const std::string& name) {
  static std::set<std::string> names;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  return *names.insert(name).first;
}

KeepingFiles::KeepingFiles(KeptFiles& files) : before_(std::exchange(kept_files, &files)) {}

KeepingFiles::~KeepingFiles() {
  kept_files = before_;
}

void keep_row_files_within(const fs::path& folder) {
  only_folder = folder.empty() ? fs::path() : fs::canonical(folder);
}

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

HeaderCell header_cell(const ColumnHead& head, const std::vector<std::string>& names) {
  HeaderCell cell = header_cell(head.name, names);
  if (cell.name.empty() || head.unit.empty()) return cell;
  std::string unit = head.unit;
  replace_all(unit, " ", ".");
  if (!cell.unit.empty() && cell.unit != unit)
    fail(head.line, head.column,
         fmt::format("the units {} and {} of {}", quote(cell.unit), quote(unit), quote(cell.name)),
         "one of both");
  cell.unit = unit;
  return cell;
}

std::string unknown_heads(TextTable& table) {
  const std::string shown = table.shown_heads();
  return "a first line that names none of these columns" + (shown.empty() ? "" : ", but " + shown);
}

std::optional<NamedFile> read_named_file(const std::string& name, const Location& named,
                                         const std::string& path, const std::string& case_file,
                                         std::vector<Mistake>& mistakes) {
  if (kept_files != nullptr)
    if (const auto known = kept_files->find(name); known != kept_files->end()) return known->second;
  const fs::path file = found_file(name, case_file, named.option);
  const auto none = [&](const std::string& found, std::string required) {
    mistakes.push_back({named, path, {"the file " + quote(file.string()) + found, std::move(required)}});
    return std::nullopt;
  };
  std::error_code error;
  if (!may_be_read(file)) return none("", "a file in the folder that was opened is required");
  if (!fs::is_regular_file(file, error))
    return none(", which is missing or no file", "a CSV file is required");
  if (fs::file_size(file, error) > largest_rows_file)
    return none(" of more than 4 MiB", "a shorter one is required");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return none(", which cannot be opened", "a CSV file is required");
  NamedFile read{file.string(), {std::istreambuf_iterator<char>(stream), {}}};
  if (kept_files != nullptr) kept_files->emplace(name, read);
  return read;
}

Entry rows_of_text(const Field& field, const std::string& text, const std::string& path,
                   const std::string& file, std::vector<Mistake>& mistakes) {
  std::istringstream stream(text);
  return RowsReader(field, path, file, mistakes).read(stream);
}

std::optional<NamedFile> file_of_block(const Field& field, const Entry& block, const std::string& path,
                                       const std::string& case_file, std::vector<Mistake>& mistakes) {
  const Member* named = find_member(block, "file");
  if (named == nullptr || block.members.size() != 1 || named->value.shape != Entry::Shape::scalar ||
      trimmed(named->value.text).empty()) {
    mistakes.push_back({block.location, path, {"a block", requirement(field) + " is required"}});
    return std::nullopt;
  }
  return read_named_file(named->value.text, block.location, path, case_file, mistakes);
}

Entry rows_of_file(const Field& field, const Entry& block, const std::string& path,
                   const std::string& case_file, std::vector<Mistake>& mistakes) {
  const auto file = file_of_block(field, block, path, case_file, mistakes);
  return file ? rows_of_text(field, file->text, path, file->name, mistakes) : Entry{};
}

}  // namespace orbearing::app
