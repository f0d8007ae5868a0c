#include "app/study/load_series.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

#include "app/case/printable.hpp"
#include "app/case/rows_file.hpp"
#include "app/case/units.hpp"
#include "app/errors.hpp"
#include "app/results/result_row.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr double kNoise = 1e-3;  // [-]  of the greatest torque: what a record at rest may show
constexpr int kMostBins = 100;   // of torque, and of speed
constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// What a record holds, with the unit in which it is kept.
struct Quantity {
  const char* name;
  const char* si;
  const char* example;
};
constexpr std::array<Quantity, 4> kQuantities{{{"time", "s", "time_s"},
                                               {"speed", "rad/s", "speed_rpm"},
                                               {"torque", "N.m", "torque_N_m"},
                                               {"power", "W", "power_kW"}}};

/// Values by quantity, in SI, and where a file that has lines holds them.
struct Table {
  std::map<std::string, std::vector<double>> values;
  std::vector<int> lines{};  // of the samples; empty: none
};

[[noreturn]] void refuse(const std::string& position, const std::string& found, const std::string& required) {
  throw BadInput(fmt::format("{}: found {}; required: {}", printable(position), printable(found), required));
}

double factor_of(const std::string& position, const Quantity& quantity, const std::string& unit) {
  if (unit.empty())
    refuse(position, fmt::format("{} without a unit", quantity.name),
           fmt::format("its unit, as in {}", quantity.example));
  const Reading<double> factor = convert(1.0, unit.substr(0, unit.find(" since ")), quantity.si);
  if (!factor.value) refuse(position, fmt::format("{}: {}", quantity.name, factor.fault), quantity.example);
  return *factor.value;
}

// A column that is read, and how.
struct Column {
  std::size_t position;
  std::string name;
  double factor;
};

std::vector<Column> columns_of(const std::string& file, int line, const std::vector<std::string>& cells) {
  std::vector<Column> columns;
  for (const Quantity& quantity : kQuantities)
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const HeaderCell cell = header_cell(cells[i], {quantity.name});
      if (cell.name.empty()) continue;
      const std::string position = fmt::format("{}:{}", file, line);
      if (std::any_of(columns.begin(), columns.end(),
                      [&](const Column& other) { return other.name == quantity.name; }))
        refuse(position, fmt::format("two columns of {}", quantity.name), "one");
      columns.push_back({i, quantity.name, factor_of(position, quantity, cell.unit)});
    }
  return columns;
}

Table table_of_csv(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Table table;
  std::vector<Column> columns;
  std::size_t head = 0;  // its columns, of which some may be passed over
  std::string text;
  for (int line = 0; next_csv_line(stream, text, line);) {
    if (const auto fault = text_fault(text))
      refuse(fmt::format("{}:{}:{}", file.string(), line, fault->column), fault->message.found,
             fault->message.required);
    std::vector<int> positions;
    const std::vector<std::string> cells = csv_cells(text, positions);
    if (columns.empty()) {
      if (!is_of_semicolons(cells)) columns = columns_of(file.string(), line, cells);
      head = cells.size();
      if (columns.empty())
        refuse(fmt::format("{}:{}:1", file.string(), line), unknown_head(text),
               "a first line with columns of time, speed and torque or power, such as "
               "time_s,speed_rpm,torque_N_m");
      continue;
    }
    if (const auto fault = row_fault(cells, positions, head))
      refuse(fmt::format("{}:{}:{}", file.string(), line, fault->column), fault->message.found,
             fault->message.required);
    for (const Column& column : columns) {
      const std::string& cell = cells[column.position];
      const Reading<double> number = read_number(cell);
      if (!number.value)
        refuse(fmt::format("{}:{}:{}", file.string(), line, positions[column.position]),
               fmt::format("{} as {}: {}", quote(cell), column.name, number.fault), "a finite number");
      table.values[column.name].push_back(*number.value * column.factor);
    }
    table.lines.push_back(line);
  }
  if (table.lines.empty())
    refuse(file.string(), columns.empty() ? "nothing" : "names of columns and no sample below them",
           "a first line such as time_s,speed_rpm,torque_N_m and a line for each sample");
  return table;
}

/// An open netCDF file.
class NetcdfFile {
 public:
  explicit NetcdfFile(const fs::path& file) : file_(file) {
    if (nc_open(file.c_str(), NC_NOWRITE, &number_) != NC_NOERR)
      refuse(file.string(), "a netCDF file that cannot be read", "an undamaged one");
  }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  ~NetcdfFile() { nc_close(number_); }

  std::optional<std::vector<double>> read(const Quantity& quantity) const {
    int variable = 0, dimensions = 0, dimension = 0;
    if (nc_inq_varid(number_, quantity.name, &variable) != NC_NOERR) return std::nullopt;
    const std::string position = fmt::format("{}: {}", file_.string(), quantity.name);
    nc_inq_varndims(number_, variable, &dimensions);
    if (dimensions != 1) refuse(position, fmt::format("{} dimensions", dimensions), "one, that of time");
    std::size_t size = 0;
    nc_inq_vardimid(number_, variable, &dimension);
    nc_inq_dimlen(number_, dimension, &size);
    std::vector<double> values(size);
    if (nc_get_var_double(number_, variable, values.data()) != NC_NOERR)
      refuse(position, "no numbers", "numbers");
    require_present(position, variable, values);
    const double scale = attribute(position, variable, "scale_factor").value_or(1.0);
    const double offset = attribute(position, variable, "add_offset").value_or(0.0);
    const double factor = factor_of(position, quantity, units(variable));
    for (double& value : values) value = (value * scale + offset) * factor;
    return values;
  }

 private:
  // The number of an attribute; none where it is not there.
  std::optional<double> attribute(const std::string& position, int variable, const char* name) const {
    const std::vector<double> numbers = attributes(position, variable, name);
    if (numbers.size() > 1) refuse(position, fmt::format("{} numbers as {}", numbers.size(), name), "one");
    return numbers.empty() ? std::nullopt : std::optional<double>(numbers.front());
  }

  std::vector<double> attributes(const std::string& position, int variable, const char* name) const {
    std::size_t length = 0;
    if (nc_inq_attlen(number_, variable, name, &length) != NC_NOERR) return {};
    std::vector<double> numbers(length);
    if (length == 0 || nc_get_att_double(number_, variable, name, numbers.data()) != NC_NOERR)
      refuse(position, fmt::format("{}, which is no number", name), "numbers in this attribute");
    return numbers;
  }

  // Values that the file itself calls missing [CF]: the fill value, stated or that of the type (of bytes none
  // is meant), missing_value, and what lies outside the valid range. All are in packed units.
  void require_present(const std::string& position, int variable, const std::vector<double>& packed) const {
    const auto refuse_at = [&](std::size_t sample, const std::string& reason) {
      refuse(fmt::format("{}: sample {}", position, sample + 1),
             fmt::format("{} ({})", packed[sample], reason), "a value for every sample");
    };
    std::vector<double> missing = attributes(position, variable, "missing_value");
    const std::vector<double> fill = attributes(position, variable, "_FillValue");
    missing.insert(missing.end(), fill.begin(), fill.end());
    if (fill.empty())
      if (const std::optional<double> default_value = default_fill(variable))
        missing.push_back(*default_value);
    const std::vector<double> range = attributes(position, variable, "valid_range");
    if (!range.empty() && range.size() != 2)
      refuse(position, fmt::format("{} numbers as valid_range", range.size()), "two");
    const double least =
        range.empty() ? attribute(position, variable, "valid_min").value_or(-kNoBound) : range[0];
    const double most =
        range.empty() ? attribute(position, variable, "valid_max").value_or(kNoBound) : range[1];
    for (std::size_t i = 0; i < packed.size(); ++i) {
      if (std::find(missing.begin(), missing.end(), packed[i]) != missing.end())
        refuse_at(i, "marked as missing by _FillValue or missing_value");
      if (packed[i] < least || packed[i] > most)
        refuse_at(i, fmt::format("outside the valid range of the file, {} to {}", least, most));
    }
  }

  // What the library fills in where nothing was written.
  std::optional<double> default_fill(int variable) const {
    nc_type type = NC_NAT;
    nc_inq_vartype(number_, variable, &type);
    switch (type) {
      case NC_SHORT:
        return NC_FILL_SHORT;
      case NC_USHORT:
        return NC_FILL_USHORT;
      case NC_INT:
        return NC_FILL_INT;
      case NC_UINT:
        return NC_FILL_UINT;
      case NC_FLOAT:
        return NC_FILL_FLOAT;
      case NC_DOUBLE:
        return NC_FILL_DOUBLE;
      default:
        return std::nullopt;
    }
  }

  std::string units(int variable) const {
    std::size_t length = 0;
    if (nc_inq_attlen(number_, variable, "units", &length) != NC_NOERR) return "";
    std::string text(length, '\0');
    if (nc_get_att_text(number_, variable, "units", text.data()) != NC_NOERR) return "";
    return text.substr(0, text.find('\0'));
  }

  fs::path file_;
  int number_ = 0;
};

Table table_of_netcdf(const fs::path& path) {
  const NetcdfFile file(path);
  Table table;
  for (const Quantity& quantity : kQuantities)
    if (auto values = file.read(quantity)) table.values[quantity.name] = std::move(*values);
  return table;
}

bool is_netcdf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(4, '\0');
  stream.read(begin.data(), 4);
  return begin.starts_with("CDF") || begin == "\x89HDF";
}

const std::vector<double>& needed(const fs::path& file, const Table& table, const Quantity& quantity) {
  const auto found = table.values.find(quantity.name);
  if (found == table.values.end())
    refuse(file.string(), fmt::format("no {}", quantity.name),
           fmt::format("it, with its unit, as in {}", quantity.example));
  return found->second;
}

std::string position_of(const fs::path& file, const Table& table, std::size_t sample) {
  return sample < table.lines.size() ? fmt::format("{}:{}", file.string(), table.lines[sample])
                                     : fmt::format("{}: sample {}", file.string(), sample + 1);
}

void require_sound(const fs::path& file, const Table& table) {
  const std::vector<double>& time = table.values.at("time");
  if (time.size() < 2)
    refuse(file.string(), fmt::format("{} samples", time.size()),
           "at least 2, since each lasts until the next");
  for (const auto& [name, values] : table.values) {
    if (values.size() != time.size())
      refuse(file.string(), fmt::format("{} times and {} values of {}", time.size(), values.size(), name),
             "as many of both");
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        refuse(position_of(file, table, i), "a value of " + name + " that is not finite", "a number");
  }
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      refuse(position_of(file, table, i), "a time that is not later than the one before", "rising times");
}

// Power over speed. At rest there is neither; a record that states one leaves its torque unknown.
std::vector<double> torque_of(const fs::path& file, const Table& table) {
  const std::vector<double>&power = table.values.at("power"), &speed = table.values.at("speed");
  double greatest = 0.0;
  for (const double one : power) greatest = std::max(greatest, std::abs(one));
  std::vector<double> torque(power.size());
  for (std::size_t i = 0; i < power.size(); ++i) {
    const bool turns = LoadBin{.speed = std::abs(speed[i])}.turns();
    if (!turns && std::abs(power[i]) > kNoise * greatest)
      refuse(position_of(file, table, i), fmt::format("a power of {:g} W at speed 0", power[i]),
             "no power at rest, or torque_N_m in place of power");
    torque[i] = turns ? power[i] / speed[i] : 0.0;
  }
  return torque;
}

/// Equal parts of a range.
struct Parts {
  double least = 0.0;
  double most = 0.0;
  int count = 1;

  void take(double value, bool first) {
    least = first ? value : std::min(least, value);
    most = first ? value : std::max(most, value);
  }
  int of(double value) const {
    constexpr double round_off = 1e-9;  // of a record that does not vary
    if (most - least <= round_off * most) return 0;
    return std::clamp(static_cast<int>((value - least) / (most - least) * count), 0, count - 1);
  }
};

struct Sums {
  double time = 0.0;    // [s]
  double turns = 0.0;   // [rad]
  double damage = 0.0;  // [rad]  with torques over the greatest one
  double steep = 0.0;   // [rad]  the same by kSteepestExponent

  /// Torque over the greatest one that does the damage.
  double torque(double exponent) const { return std::pow(damage / turns, 1.0 / exponent); }
};

/// Damage of the samples over that of their bins, less 1, for a life by kSteepestExponent.
double steep_excess(const std::map<std::pair<int, int>, Sums>& bins, double exponent) {
  double samples = 0.0, means = 0.0;
  for (const auto& [position, sums] : bins) {
    samples += sums.steep;
    means += sums.turns * std::pow(sums.torque(exponent), kSteepestExponent);
  }
  return means > 0.0 ? samples / means - 1.0 : 0.0;
}

}  // namespace

LoadSeries read_load_series(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored))
    refuse(file.string(), "no file", "a CSV or netCDF file of a record over time");
  if (file.extension() == ".nc" && !is_netcdf(file))
    refuse(file.string(), "a name that ends in .nc, and a content that does not begin as netCDF does",
           "an undamaged netCDF file, or a CSV file of another name");
  const Table table = is_netcdf(file) ? table_of_netcdf(file) : table_of_csv(file);
  LoadSeries series{needed(file, table, kQuantities[0]), {}, needed(file, table, kQuantities[1])};
  const bool by_torque = table.values.contains("torque");
  if (!by_torque && !table.values.contains("power"))
    refuse(file.string(), "no torque and no power",
           "one of both with its unit, as in torque_N_m or power_kW");
  require_sound(file, table);
  series.torque = by_torque ? table.values.at("torque") : torque_of(file, table);
  if (by_torque && table.values.contains("power"))
    series.warnings.push_back(file.string() + ": torque and power found; torque was taken");
  return series;
}

BinCounts parse_bins(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto count = [&](const std::string& part) {
    const Reading<double> number = read_number(part);
    const bool whole = number.value && *number.value == std::floor(*number.value);
    return whole && *number.value >= 1.0 && *number.value <= kMostBins ? static_cast<int>(*number.value) : 0;
  };
  const BinCounts counts{count(text.substr(0, cross)),
                         cross == std::string::npos ? 0 : count(text.substr(cross + 1))};
  if (counts.torque == 0 || counts.speed == 0)
    throw BadInput(fmt::format(
        "--bins: found {}; required: numbers of bins of torque and of speed from 1 to {}, as in 8x8",
        quote(text), kMostBins));
  return counts;
}

BinnedSeries binned(const LoadSeries& series, const BinCounts& counts, double exponent) {
  const auto magnitudes = [&](std::size_t i) {
    return LoadBin{.power = std::abs(series.torque[i] * series.speed[i]), .speed = std::abs(series.speed[i])};
  };
  Parts torques{.count = counts.torque}, speeds{.count = counts.speed};
  bool any = false;
  const std::size_t last = series.time.size() - 1;  // the last sample lasts for no time
  for (std::size_t i = 0; i < last; ++i) {
    if (!magnitudes(i).turns()) continue;
    torques.take(std::abs(series.torque[i]), !any);
    speeds.take(std::abs(series.speed[i]), !any);
    any = true;
  }
  if (!any) throw BadInput("record: found a drivetrain at rest; required: a speed above 0 at some time");
  const double greatest = torques.most > 0.0 ? torques.most : 1.0;
  std::map<std::pair<int, int>, Sums> bins;
  BinnedSeries result{.duration = series.time.back() - series.time.front()};
  double rest = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    const double time = series.time[i + 1] - series.time[i];
    const double speed = std::abs(series.speed[i]), torque = std::abs(series.torque[i]);
    if (!magnitudes(i).turns()) {
      rest += time;
      if (torque > kNoise * greatest) result.loaded_rest_share += time / result.duration;
      continue;
    }
    if (series.speed[i] < 0.0 || series.torque[i] < 0.0) result.reversed_share += time / result.duration;
    Sums& sums = bins[{torques.of(torque), speeds.of(speed)}];
    sums.time += time;
    sums.turns += time * speed;
    sums.damage += time * speed * std::pow(torque / greatest, exponent);
    sums.steep += time * speed * std::pow(torque / greatest, kSteepestExponent);
  }
  for (const auto& [position, sums] : bins) {
    const double speed = sums.turns / sums.time;
    const double torque = greatest * sums.torque(exponent);
    result.spectrum.bins.push_back({torque * speed, speed, sums.time / result.duration});
  }
  result.steep_excess = steep_excess(bins, exponent);
  if (rest > 0.0) result.spectrum.bins.push_back({0.0, 0.0, rest / result.duration});
  return result;
}

std::string spectrum_file(const LoadSpectrum& spectrum) {
  std::string text = "torque_N_m,speed_rpm,share\n";
  for (const LoadBin& bin : spectrum.bins)
    text += fmt::format("{},{},{}\n", in_table_unit(bin.turns() ? bin.power / bin.speed : 0.0, 1.0),
                        speed_in_rpm(bin.speed), bin.share);
  return text;
}

}  // namespace orbearing::app
