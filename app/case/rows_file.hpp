// Rows of a list, or of a matrix, in a separate file, which {file: loads.csv} names instead of the list.
//
//     speed_rpm, torque_N_m, share        a column for each name of the field, its unit in the header:
//     6000, 238.7, 0.4                    "torque_N_m", "torque [N.m]", "torque (N m)"; without one each cell
//     has its own: "6000 rpm"
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/case/field.hpp"
#include "app/case/text_table.hpp"

namespace orbearing::app {

/// Longest file of rows [byte], and most rows.
inline constexpr std::size_t largest_rows_file = 4U << 20U;
inline constexpr std::size_t most_file_rows = 10000;

/// From now on this process reads such files from `folder` and what is below it alone; from nowhere where it
/// is empty.
void keep_row_files_within(const std::filesystem::path& folder);

/// Name and unit of a column's header: "torque_N_m" is "torque" and "N.m". The name is empty where none of
/// `names` begins it.
struct HeaderCell {
  std::string name;
  std::string unit;
};
HeaderCell header_cell(const std::string& text, const std::vector<std::string>& names);

/// The same with the unit of a line of units. Throws TableFault where the name holds another.
HeaderCell header_cell(const ColumnHead& head, const std::vector<std::string>& names);

/// How a head that names none of the required columns is shown: what a file that is no table of numbers holds
/// is not.
std::string unknown_heads(TextTable& table);

/// The list that the file holds, every entry with its place there. Lines that are empty or begin with # are
/// passed over. `file` is taken from the folder of `case_file`. What is wrong with the file as a whole, or
/// with its header, is added to `mistakes`, with the list empty; what is wrong with a value is found when the
/// list is read.
Entry rows_of_file(const Field& field, const Entry& block, const std::string& path,
                   const std::string& case_file, std::vector<Mistake>& mistakes);

/// Most rows and columns of a matrix.
inline constexpr std::size_t most_matrix_rows = 60;

/// Elements of a square matrix row by row, from a file as rows_of_file() takes one:
///
///     x1       y1       z1       x2      ...     three columns for each bearing: across, upward, along the
///     axis (N/mm)   (N/mm)   (N/mm)   (N/mm)  ...     in brackets, or behind the names: x1_N_per_mm
///     3.1e6    2.0e4    0        4.5e5   ...     as many rows as columns, in their order
Entry matrix_of_file(const Field& field, const Entry& block, const std::string& path,
                     const std::string& case_file, std::vector<Mistake>& mistakes);

/// The same list as rows_of_file() from the text of `file`.
Entry rows_of_text(const Field& field, const std::string& text, const std::string& path,
                   const std::string& file, std::vector<Mistake>& mistakes);

/// A file that the case names, from its folder.
struct NamedFile {
  std::string name;  // as it is opened
  std::string text;
};

/// Files that a case names, by the name that it writes: what was read once is not read again.
using KeptFiles = std::map<std::string, NamedFile>;

/// While it lives, read_named_file() of this thread takes files from `files`, and adds those that it reads.
class KeepingFiles {
 public:
  explicit KeepingFiles(KeptFiles& files);
  ~KeepingFiles();
  KeepingFiles(const KeepingFiles&) = delete;
  KeepingFiles& operator=(const KeepingFiles&) = delete;

 private:
  KeptFiles* before_;
};

/// A file name that outlives its reader, for locations.
std::string_view lasting(const std::string& name);

/// The file that {file: NAME} names instead of the field's list; none where it cannot be read, with the
/// mistake added.
std::optional<NamedFile> file_of_block(const Field& field, const Entry& block, const std::string& path,
                                       const std::string& case_file, std::vector<Mistake>& mistakes);

/// None where it cannot be read, with the mistake added at `named`, the location of its name.
std::optional<NamedFile> read_named_file(const std::string& name, const Location& named,
                                         const std::string& path, const std::string& case_file,
                                         std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
