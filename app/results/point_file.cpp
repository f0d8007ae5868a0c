#include "app/results/point_file.hpp"

#include <fmt/format.h>
#include <netcdf_meta.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>

#include "app/errors.hpp"
#include "app/results/netcdf_library.hpp"

namespace orbearing::app {
namespace {

constexpr std::size_t first_bytes = 16384;     // of the file in memory, which grows as needed
constexpr std::size_t compressed_from = 4096;  // [values]  below it compressing costs more than it saves
// A library without HDF5, as that of the wheel, has the classic format only, which is not compressed.
constexpr int file_format = NC_HAS_HDF5 ? NC_NETCDF4 : NC_64BIT_OFFSET;

void check(int status) {
  if (status != NC_NOERR)
    throw ComputationFailed(
        fmt::format("point file: the netCDF library says: {}", netcdf().strerror(status)));
}

/// A file in memory, closed without result unless `bytes` was called.
class MemoryFile {
 public:
  MemoryFile() { check(netcdf().create_mem("point", file_format, first_bytes, &number_)); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (open_) netcdf().abort(number_);
  }

  int number() const { return number_; }

  std::string bytes() {
    NC_memio memory{};
    open_ = false;
    check(netcdf().close_memio(number_, &memory));
    const std::unique_ptr<void, decltype(&std::free)> owned(memory.memory, &std::free);
    return {static_cast<const char*>(memory.memory), memory.size};
  }

 private:
  int number_ = -1;
  bool open_ = true;
};

void put_text(int file, int variable, const char* name, const std::string& text) {
  check(netcdf().put_att_text(file, variable, name, text.size(), text.c_str()));
}

int define(int file, const NamedArray& array, const std::map<std::string, int>& dimensions) {
  std::vector<int> ids;
  for (const std::string& name : array.dimensions) ids.push_back(dimensions.at(name));
  int variable = 0;
  check(netcdf().def_var(file, array.name.c_str(), NC_DOUBLE, static_cast<int>(ids.size()), ids.data(),
                         &variable));
  check(netcdf().def_var_fill(file, variable, NC_FILL, &not_given));
  if (NC_HAS_HDF5 && array.values.size() >= compressed_from)
    check(netcdf().def_var_deflate(file, variable, 1, 1, 1));
  put_text(file, variable, "units", array.units);
  put_text(file, variable, "long_name", array.meaning);
  return variable;
}

std::string variable_name(std::string column) {
  std::replace(column.begin(), column.end(), '.', '_');
  return column;
}

// A failed point has results of no set.
void describe_sets(Record& record, const std::vector<std::string>& names,
                   const analysis::PointResult& result) {
  record.child("sets", "each by itself", result.sets, [&](Record& sets, const auto& results) {
    for (std::size_t i = 0; i < names.size(); ++i)
      sets.child(names[i], "one of several sets", i < results.size() ? results[i] : analysis::SetResult{});
  });
}

void forget_all_but_speed(PointContent& content) {
  for (NamedArray& array : content.arrays)
    if (array.name != "input_speed") array.values = {not_given};
}

}  // namespace

std::vector<std::pair<std::string, std::string>> result_attributes(const ManifestHeader& header,
                                                                   const std::string& what,
                                                                   const std::string& status) {
  return {{"Conventions", "CF-1.10"},
          {"title", header.case_name + ", " + what},
          {"source", "Orbearing " + header.program_version},
          {"case", header.case_name},
          {"case_hash", header.case_hash},
          {"program_version", header.program_version},
          {"instruction_set", header.instruction_set},
          {"fidelity", header.fidelity},
          {"status", status}};
}

PointContent point_content(const ManifestHeader& header, std::size_t point,
                           const std::vector<double>& axis_values, const analysis::PointResult& result) {
  Record record = record_of(result);
  if (!header.sets.empty()) describe_sets(record, header.sets, result);
  PointContent content = content_of(record);
  if (!is_computed(result.status)) forget_all_but_speed(content);
  for (std::size_t i = 0; i < header.axes.size(); ++i)
    content.add(variable_name(header.axes[i].column), header.axes[i].units, header.axes[i].meaning,
                axis_values[i]);
  content.attributes = result_attributes(header, fmt::format("operating point {}", point), result.status);
  if (header.continued) content.attributes.emplace_back("continue", to_string(*header.continued));
  if (!header.sets.empty()) content.attributes.emplace_back("limiting_set", result.limiting_set);
  return content;
}

void add_location_in_sweep(bool refined, const std::optional<Resonance>& resonance, PointContent& content) {
  content.attributes.emplace_back("refined", refined ? "true" : "false");
  if (!resonance) return;
  const PointContent own = content_of(record_of(*resonance));
  content.attributes.insert(content.attributes.end(), own.attributes.begin(), own.attributes.end());
  content.arrays.insert(content.arrays.end(), own.arrays.begin(), own.arrays.end());
}

std::string netcdf_bytes(const PointContent& content) {
  MemoryFile file;
  std::map<std::string, int> dimensions;
  for (const NamedDimension& dimension : content.dimensions)
    check(
        netcdf().def_dim(file.number(), dimension.name.c_str(), dimension.size, &dimensions[dimension.name]));
  std::vector<int> variables;
  for (const NamedArray& array : content.arrays)
    variables.push_back(define(file.number(), array, dimensions));
  for (const auto& [name, text] : content.attributes) put_text(file.number(), NC_GLOBAL, name.c_str(), text);
  check(netcdf().enddef(file.number()));
  for (std::size_t i = 0; i < variables.size(); ++i)
    check(netcdf().put_var_double(file.number(), variables[i], content.arrays[i].values.data()));
  return file.bytes();
}

std::vector<double> read_final_state(const std::filesystem::path& file) {
  int number = 0;
  if (netcdf().open(file.c_str(), NC_NOWRITE, &number) != NC_NOERR) return {};
  int variable = 0;
  int dimension = 0;
  std::size_t size = 0;
  std::vector<double> state;
  if (netcdf().inq_varid(number, analysis::kFinalState, &variable) == NC_NOERR &&
      netcdf().inq_vardimid(number, variable, &dimension) == NC_NOERR &&
      netcdf().inq_dimlen(number, dimension, &size) == NC_NOERR) {
    state.resize(size);
    if (netcdf().get_var_double(number, variable, state.data()) != NC_NOERR) state.clear();
  }
  netcdf().close(number);
  return state;
}

}  // namespace orbearing::app
