// Records over time in netCDF.
#include <fmt/format.h>
#include <netcdf_meta.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "app/results/netcdf_library.hpp"
#include "app/study/record_file.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr double kNoBound = std::numeric_limits<double>::infinity();

// A library without HDF5, as that of the wheel, reads the classic format alone.
constexpr const char* readable_file =
    NC_HAS_HDF5 ? "an undamaged one" : "an undamaged one of the classic format (nccopy -k classic OLD NEW)";

/// An open netCDF file.
class NetcdfFile {
 public:
  explicit NetcdfFile(const fs::path& file) : file_(file) {
    if (netcdf().open(file.c_str(), NC_NOWRITE, &number_) != NC_NOERR)
      refuse_record(file.string(), "a netCDF file that cannot be read", readable_file);
  }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  ~NetcdfFile() { netcdf().close(number_); }

  std::vector<ColumnHead> heads() const {
    int count = 0;
    netcdf().inq_nvars(number_, &count);
    std::vector<ColumnHead> heads;
    for (int variable = 0; variable < count; ++variable) {
      std::string name(NC_MAX_NAME + 1, '\0');
      netcdf().inq_varname(number_, variable, name.data());
      const std::string unit = units(variable);  // "seconds since 2026-01-01" counts seconds
      heads.push_back({name.substr(0, name.find('\0')), unit.substr(0, unit.find(" since "))});
    }
    return heads;
  }

  std::vector<double> read(int variable, const std::string& name, double factor) const {
    int dimensions = 0, dimension = 0;
    const std::string position = fmt::format("{}: {}", file_.string(), name);
    netcdf().inq_varndims(number_, variable, &dimensions);
    if (dimensions != 1)
      refuse_record(position, fmt::format("{} dimensions", dimensions), "one, that of time");
    std::size_t size = 0;
    netcdf().inq_vardimid(number_, variable, &dimension);
    netcdf().inq_dimlen(number_, dimension, &size);
    std::vector<double> values(size);
    if (netcdf().get_var_double(number_, variable, values.data()) != NC_NOERR)
      refuse_record(position, "no numbers", "numbers");
    require_present(position, variable, values);
    const double scale = attribute(position, variable, "scale_factor").value_or(1.0);
    const double offset = attribute(position, variable, "add_offset").value_or(0.0);
    for (double& value : values) value = (value * scale + offset) * factor;
    return values;
  }

 private:
  // The number of an attribute; none where it is not there.
  std::optional<double> attribute(const std::string& position, int variable, const char* name) const {
    const std::vector<double> numbers = attributes(position, variable, name);
    if (numbers.size() > 1)
      refuse_record(position, fmt::format("{} numbers as {}", numbers.size(), name), "one");
    return numbers.empty() ? std::nullopt : std::optional<double>(numbers.front());
  }

  std::vector<double> attributes(const std::string& position, int variable, const char* name) const {
    std::size_t length = 0;
    if (netcdf().inq_attlen(number_, variable, name, &length) != NC_NOERR) return {};
    std::vector<double> numbers(length);
    if (length == 0 || netcdf().get_att_double(number_, variable, name, numbers.data()) != NC_NOERR)
      refuse_record(position, fmt::format("{}, which is no number", name), "numbers in this attribute");
    return numbers;
  }

  // Values that the file itself calls missing [CF]: the fill value, stated or that of the type (of bytes none
  // is meant), missing_value, and what lies outside the valid range. All are in packed units.
  void require_present(const std::string& position, int variable, const std::vector<double>& packed) const {
    const auto refuse_at = [&](std::size_t sample, const std::string& reason) {
      refuse_record(fmt::format("{}: sample {}", position, sample + 1),
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
      refuse_record(position, fmt::format("{} numbers as valid_range", range.size()), "two");
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

  // Value that the library fills in where nothing was written.
  std::optional<double> default_fill(int variable) const {
    nc_type type = NC_NAT;
    netcdf().inq_vartype(number_, variable, &type);
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
    if (netcdf().inq_attlen(number_, variable, "units", &length) != NC_NOERR) return "";
    std::string text(length, '\0');
    if (netcdf().get_att_text(number_, variable, "units", text.data()) != NC_NOERR) return "";
    return text.substr(0, text.find('\0'));
  }

  fs::path file_;
  int number_ = 0;
};

}  // namespace

RecordTable record_of_netcdf(const fs::path& path, const RecordColumns& wanted) {
  const NetcdfFile file(path);
  const std::vector<ColumnHead> heads = file.heads();
  const auto place = [&](const ColumnHead& head) { return fmt::format("{}: {}", path.string(), head.name); };
  RecordTable record;
  for (const ChosenColumn& column :
       chosen_columns({heads, path.string(), columns_text(heads), place, true}, wanted)) {
    if (column.beside) continue;  // a variable along another dimension is refused when it is read
    record.values[column.quantity] =
        file.read(static_cast<int>(column.position), heads[column.position].name, column.factor);
    record.factors[column.quantity] = column.factor;
  }
  return record;
}

}  // namespace orbearing::app
