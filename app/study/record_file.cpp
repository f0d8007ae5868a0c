#include "app/study/record_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>

#include "app/case/field_table.hpp"
#include "app/case/rows_file.hpp"
#include "app/case/units.hpp"
#include "app/errors.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRecords = "a record over time: CSV, .out or .outb of OpenFAST, Bladed, or netCDF";

/// Quantity of a record, with the unit in which it is kept.
struct Quantity {
  const char* name;
  const char* si;
  const char* example;
  std::string RecordColumns::*stated;
};
constexpr std::array<Quantity, 4> kQuantities{{{"time", "s", "time_s", &RecordColumns::time},
                                               {"speed", "rad/s", "speed_rpm", &RecordColumns::speed},
                                               {"torque", "N.m", "torque_N_m", &RecordColumns::torque},
                                               {"power", "W", "power_kW", &RecordColumns::power}}};

Reading<double> factor_in(const std::string& unit, const Quantity& quantity) {
  return convert(1.0, unit, quantity.si);
}

// The unit at the end of a whole name, as "Drehmoment_N_m" has it; none where several ends are units of the
// quantity.
std::string unit_at_end(const std::string& name, const Quantity& quantity) {
  std::vector<std::string> units;
  for (std::size_t at = name.find_first_of("_ [("); at != std::string::npos;
       at = name.find_first_of("_ [(", at + 1)) {
    const std::string unit = header_cell(name, {name.substr(0, at)}).unit;
    if (!unit.empty() && factor_in(unit, quantity).value &&
        std::find(units.begin(), units.end(), unit) == units.end())
      units.push_back(unit);
  }
  return units.size() == 1 ? units.front() : "";
}

// The column's unit, where its head is that of the quantity.
std::optional<std::string> unit_of(const ColumnHead& head, const Quantity& quantity,
                                   const std::string& stated, bool whole_names) {
  if (!stated.empty() && head.name == stated)
    return head.unit.empty() ? unit_at_end(head.name, quantity) : header_cell({"x", head.unit}, {"x"}).unit;
  std::vector<std::string> names{stated.empty() ? quantity.name : stated};
  if (stated.empty() || stated == "time") {  // "Torque [N m]" as well
    std::string capital = names.front();
    capital.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(capital.front())));
    names.push_back(capital);
  }
  if (whole_names && std::find(names.begin(), names.end(), head.name) == names.end()) return std::nullopt;
  const HeaderCell cell = header_cell(head, names);
  return cell.name.empty() ? std::nullopt : std::optional(cell.unit);
}

double factor_of(const std::string& position, const Quantity& quantity, const std::string& unit) {
  if (unit.empty())
    refuse_record(position, fmt::format("{} without a unit", quantity.name),
                  fmt::format("its unit, as in {}", quantity.example));
  const Reading<double> factor = factor_in(unit, quantity);
  if (!factor.value)
    refuse_record(position, fmt::format("{}: {}", quantity.name, factor.fault), quantity.example);
  return *factor.value;
}

// Torque and power replace each other: if the name of one is stated, the other is not searched for.
bool is_wanted(const Quantity& quantity, const RecordColumns& columns) {
  if (!columns.torque.empty() && quantity.stated == &RecordColumns::power) return false;
  return columns.power.empty() || quantity.stated != &RecordColumns::torque;
}

[[noreturn]] void refuse_missing(const RecordHeads& offered, const std::vector<std::string>& missing) {
  const auto has = [&](const char* name) {
    return std::find(missing.begin(), missing.end(), name) != missing.end();
  };
  std::vector<std::string> options, names;
  for (const Quantity& quantity : kQuantities) {
    if (!has(quantity.name)) continue;
    options.push_back(fmt::format("--{} COLUMN", quantity.name));
    names.emplace_back(quantity.example);
  }
  if (has("torque")) {
    options.back() = "--torque COLUMN or --power COLUMN";
    names.back() = "torque_N_m or power_kW";
  }
  const std::string what = fmt::format("no {}", fmt::join(missing, ", no "));
  refuse_record(
      offered.position, offered.shown.empty() ? what : what + " among the columns " + offered.shown,
      fmt::format("{}, or names such as {} in the file", fmt::join(options, ", "), fmt::join(names, ", ")));
}

[[noreturn]] void refuse_stated(const RecordHeads& offered, const Quantity& quantity,
                                const std::string& stated) {
  std::vector<std::string> names;
  for (const ColumnHead& head : offered.heads)  // "RotTorq" of "RotTorq_[kN-m]"
    names.push_back(head.name.substr(0, head.name.find_first_of("[(")));
  for (std::string& name : names)
    if (name.size() > 1 && (name.back() == '_' || name.back() == ' ')) name.pop_back();
  const std::string near = nearest_word(stated, names);
  refuse_record(offered.position, fmt::format("no column {} of --{}", quote(stated), quantity.name),
                (offered.shown.empty() ? "a column of the file" : "one of " + offered.shown) +
                    (near.empty() ? "" : fmt::format("; did you mean {}?", quote(near))));
}

RecordTable record_of_text(const fs::path& file, const RecordColumns& wanted) {
  std::ifstream stream(file, std::ios::binary);
  RecordTable record;
  try {
    TextTable table(stream);
    const auto place = [&](const ColumnHead& head) {
      return fmt::format("{}:{}:{}", file.string(), head.line, head.column);
    };
    if (table.heads().empty())
      refuse_record(file.string(), "nothing",
                    "a first line such as time_s,speed_rpm,torque_N_m and a line for each sample");
    const std::string position = fmt::format("{}:{}:1", file.string(), table.head_line());
    if (std::ranges::all_of(table.heads(),
                            [](const ColumnHead& head) { return read_number(head.name).value.has_value(); }))
      refuse_record(position, "numbers, and no line above them with the names of the columns",
                    "a first line such as time_s,speed_rpm,torque_N_m");
    const std::vector<ChosenColumn> columns =
        chosen_columns({table.heads(), position, table.shown_heads(), place}, wanted);
    for (std::vector<TableCell> cells; table.next(cells);) {
      for (const ChosenColumn& column : columns) {
        const TableCell& cell = cells[column.position];
        const Reading<double> number = read_number(table.number_text(cell));
        if (!number.value && column.beside) continue;
        if (!number.value)
          refuse_record(fmt::format("{}:{}:{}", file.string(), table.line(), cell.column),
                        fmt::format("{} as {}: {}", quote(cell.text), column.quantity, number.fault),
                        "a finite number");
        record.take(column, *number.value);
      }
      record.lines.push_back(table.line());
    }
    table.require_plain_decimals();
    for (const std::string& warning : table.warnings())
      record.warnings.push_back(file.string() + ": " + warning);
  } catch (const TableFault& fault) {
    refuse_record(fmt::format("{}:{}:{}", file.string(), fault.line, fault.column), fault.message.found,
                  fault.message.required);
  }
  if (record.lines.empty())
    refuse_record(file.string(), "names of columns and no sample below them",
                  "a first line such as time_s,speed_rpm,torque_N_m and a line for each sample");
  return record;
}

std::string first_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(4, '\0');
  stream.read(begin.data(), 4);
  return begin;
}

bool is_netcdf(const std::string& begin) {
  return begin.starts_with("CDF") || begin == "\x89HDF";
}

// "NAME.%04" is the header of the data "NAME.$04".
bool is_bladed(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension.starts_with(".%") || extension.starts_with(".$");
}

// Its first number, of two bytes, is that of the form: 1 to 4.
bool is_openfast(const std::string& begin) {
  return begin[0] >= 1 && begin[0] <= 4 && begin[1] == '\0';
}

// Columns of other names in a unit of power, where a torque is read.
void add_powers(const RecordHeads& offered, const RecordColumns& columns, std::vector<ChosenColumn>& chosen) {
  const Quantity& power = kQuantities.back();
  const auto is_chosen = [&](std::size_t position, const char* quantity) {
    return std::ranges::any_of(chosen, [&](const ChosenColumn& one) {
      return one.position == position || one.quantity == quantity;
    });
  };
  if (!is_chosen(offered.heads.size(), "torque") || is_chosen(offered.heads.size(), "power")) return;
  for (std::size_t i = 0; i < offered.heads.size(); ++i) {
    const ColumnHead& head = offered.heads[i];
    const std::string unit =
        head.unit.empty() ? unit_at_end(head.name, power) : header_cell({"x", head.unit}, {"x"}).unit;
    if (unit.empty() || is_chosen(i, "") || head.name == columns.speed) continue;
    if (const Reading<double> factor = factor_in(unit, power); factor.value)
      chosen.push_back({i, head.name, *factor.value, true});
  }
}

}  // namespace

void refuse_record(const std::string& position, const std::string& found, const std::string& required) {
  throw BadInput(fmt::format("{}: found {}; required: {}", printable(position), printable(found), required));
}

std::vector<ChosenColumn> chosen_columns(const RecordHeads& offered, const RecordColumns& columns) {
  std::vector<ChosenColumn> chosen;
  std::vector<std::string> missing;
  for (const Quantity& quantity : kQuantities) {
    if (!is_wanted(quantity, columns)) continue;
    const std::string& stated = columns.*quantity.stated;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < offered.heads.size(); ++i)
      if (unit_of(offered.heads[i], quantity, stated, offered.whole_names)) found.push_back(i);
    if (found.size() > 1)
      refuse_record(offered.place(offered.heads[found[1]]), fmt::format("two columns of {}", quantity.name),
                    stated.empty() ? fmt::format("one, or --{} COLUMN", quantity.name) : "one");
    if (!found.empty()) {
      const ColumnHead& head = offered.heads[found.front()];
      chosen.push_back(
          {found.front(), quantity.name,
           factor_of(offered.place(head), quantity, *unit_of(head, quantity, stated, offered.whole_names))});
    } else if (!stated.empty()) {
      refuse_stated(offered, quantity, stated);
    } else {
      missing.emplace_back(quantity.name);
    }
  }
  // One of torque and power is enough.
  const auto is_load = [](const std::string& name) { return name == "torque" || name == "power"; };
  if (std::any_of(chosen.begin(), chosen.end(),
                  [&](const ChosenColumn& one) { return is_load(one.quantity); }))
    std::erase_if(missing, is_load);
  else
    std::erase(missing, "power");
  if (chosen.empty() && offered.shown.empty())
    refuse_record(offered.position, "a first line that names none of these columns",
                  "a first line with columns of time, speed and torque or power, such as "
                  "time_s,speed_rpm,torque_N_m");
  if (!missing.empty()) refuse_missing(offered, missing);
  add_powers(offered, columns, chosen);
  return chosen;
}

RecordTable read_record(const fs::path& file, const RecordColumns& columns) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) refuse_record(file.string(), "no file", kRecords);
  const std::string begin = first_bytes(file);
  if (is_bladed(file)) return record_of_bladed(file, columns);
  if (const ForeignRecord foreign = foreign_record(file); !foreign.kind.empty())
    refuse_record(file.string(), foreign.kind, kRecords + std::string("; ") + foreign.remedy);
  if (is_netcdf(begin)) return record_of_netcdf(file, columns);
  if (file.extension() == ".nc")
    refuse_record(file.string(), "a name that ends in .nc, and a content that does not begin as netCDF does",
                  "an undamaged netCDF file, or a CSV file of another name");
  return is_openfast(begin) ? record_of_openfast(file, columns) : record_of_text(file, columns);
}

}  // namespace orbearing::app
