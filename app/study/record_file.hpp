// A record over time in a file: CSV, output of OpenFAST as text (.out) and binary (.outb), of Bladed (header
// % and data $), netCDF.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/case/text_table.hpp"

namespace orbearing::app {

/// Columns, or variables, by the names that a user states; empty: the quantity's own name begins that of the
/// column.
struct RecordColumns {
  std::string time{};
  std::string speed{};
  std::string torque{};
  std::string power{};
};

/// A column that is read, its place among all and its unit in SI.
struct ChosenColumn {
  std::size_t position = 0;
  std::string quantity;  // of a power beside them: its name
  double factor = 1.0;
  bool beside = false;  // a power that shows whether torque and speed are of one shaft
};

/// Samples by quantity (time, speed, torque, power), in SI.
struct RecordTable {
  std::map<std::string, std::vector<double>> values{};
  std::map<std::string, double> factors{};              // SI over the unit of the file, by quantity
  std::map<std::string, std::vector<double>> powers{};  // [W]  beside them, by the names of their columns
  std::vector<int> lines{};                             // of the samples; empty: the file has none
  std::vector<std::string> warnings{};

  /// A sample in the unit of the file.
  void take(const ChosenColumn& column, double value) {
    (column.beside ? powers : values)[column.quantity].push_back(value * column.factor);
    if (!column.beside) factors[column.quantity] = column.factor;
  }
};

/// Time, speed and torque or power, by the units that the file states. Other columns are passed over. Throws
/// BadInput with the place of what is missing, has no unit or is no number.
RecordTable read_record(const std::filesystem::path& file, const RecordColumns& columns);

[[noreturn]] void refuse_record(const std::string& position, const std::string& found,
                                const std::string& required);

// Parts of read_record().

/// Columns of a file, and the names of their locations in a message.
struct RecordHeads {
  std::vector<ColumnHead> heads;
  std::string position;                                        // of the heads as a whole
  std::string shown;                                           // empty: not to be shown
  std::function<std::string(const ColumnHead& head)> place{};  // of one of them
  bool whole_names = false;                                    // units are not part of the names
};

/// Throws BadInput where a quantity is missing, is listed twice or has no unit of its kind. With a torque
/// come all columns of another name whose unit is one of power.
std::vector<ChosenColumn> chosen_columns(const RecordHeads& offered, const RecordColumns& columns);

RecordTable record_of_netcdf(const std::filesystem::path& file, const RecordColumns& columns);
/// Header and data beside each other, by the name of either.
RecordTable record_of_bladed(const std::filesystem::path& file, const RecordColumns& columns);

/// A kind of file that is not read, and how its content becomes a CSV file; an empty kind: none of them.
struct ForeignRecord {
  std::string kind;
  std::string remedy{};
};
ForeignRecord foreign_record(const std::filesystem::path& file);

RecordTable record_of_openfast(const std::filesystem::path& file, const RecordColumns& columns);

}  // namespace orbearing::app
