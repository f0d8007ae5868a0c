#include "app/results/point_file.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>

#include "app/errors.hpp"
#include "app/results/series_content.hpp"

namespace orbearing::app {
namespace {

constexpr std::size_t first_bytes = 16384;     // of the file in memory, which grows as needed
constexpr std::size_t compressed_from = 4096;  // [values]  below it compressing costs more than it saves

void check(int status) {
  if (status != NC_NOERR)
    throw ComputationFailed(fmt::format("point file: the netCDF library says: {}", nc_strerror(status)));
}

/// A file in memory, closed without result unless `bytes` was called.
class MemoryFile {
 public:
  MemoryFile() { check(nc_create_mem("point", NC_NETCDF4, first_bytes, &number_)); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (open_) nc_abort(number_);
  }

  int number() const { return number_; }

  std::string bytes() {
    NC_memio memory{};
    open_ = false;
    check(nc_close_memio(number_, &memory));
    const std::unique_ptr<void, decltype(&std::free)> owned(memory.memory, &std::free);
    return {static_cast<const char*>(memory.memory), memory.size};
  }

 private:
  int number_ = -1;
  bool open_ = true;
};

void put_text(int file, int variable, const char* name, const std::string& text) {
  check(nc_put_att_text(file, variable, name, text.size(), text.c_str()));
}

int define(int file, const NamedArray& array, const std::map<std::string, int>& dimensions) {
  std::vector<int> ids;
  for (const std::string& name : array.dimensions) ids.push_back(dimensions.at(name));
  int variable = 0;
  check(nc_def_var(file, array.name.c_str(), NC_DOUBLE, static_cast<int>(ids.size()), ids.data(), &variable));
  check(nc_def_var_fill(file, variable, NC_FILL, &not_given));
  if (array.values.size() >= compressed_from) check(nc_def_var_deflate(file, variable, 1, 1, 1));
  put_text(file, variable, "units", array.units);
  put_text(file, variable, "long_name", array.meaning);
  return variable;
}

std::string variable_name(std::string column) {
  std::replace(column.begin(), column.end(), '.', '_');
  return column;
}

void add_scalars(PointContent& content, const std::vector<Column>& columns,
                 const study::PointResult& result) {
  for (const Column& column : columns) {
    const bool known = is_computed(result.status) || column.variable == "input_speed";
    content.add(column.variable, column.units, column.meaning, known ? column.value(result) : not_given);
  }
}

// Of each of several sets; a failed point has none.
void add_sets(PointContent& content, const std::vector<std::string>& sets, const study::PointResult& result) {
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const SetColumn& column : set_columns()) {
      const bool known = is_computed(result.status) && i < result.sets.size();
      content.add("sets_" + sets[i] + "_" + column.variable, column.units,
                  column.meaning + ", set " + sets[i], known ? column.value(result.sets[i]) : not_given);
    }
}

void add_distribution(PointContent& content, const study::LoadDistribution& loads) {
  content.add_dimension("place", loads.angle.size());
  content.add("angle", {"place"}, "rad",
              "place on the race, from the outward radial direction towards carrier rotation", loads.angle);
  content.add("inner_load", {"place"}, "N", "load of a roller on the inner race", loads.inner_load);
  content.add("outer_load", {"place"}, "N", "load of a roller on the outer race", loads.outer_load);
  if (!loads.race_form.empty())
    content.add("race_form", {"place"}, "m",
                "outward displacement of the outer race by bending of the planet's rim", loads.race_form);
}

// Lives by the standards of each bearing or planet.
template <class Results>
void add_rated_hours(PointContent& content, const std::string& dimension, const Results& results) {
  using bearing::rating::RatedHours;
  const auto add = [&](const char* life, const char* meaning, double RatedHours::*hours) {
    content.add_each(dimension + "_" + life, {dimension}, "h", meaning, results,
                     [hours](const auto& one) { return one.rated_hours.*hours; });
  };
  add("L10h", "basic rating life of ISO 281 of one bearing", &RatedHours::basic);
  add("L10rh", "basic reference rating life of ISO/TS 16281 of one bearing", &RatedHours::reference);
  add("L10mh", "modified rating life of ISO 281 of one bearing", &RatedHours::modified);
  add("L10mrh", "modified reference rating life of ISO/TS 16281 of one bearing",
      &RatedHours::modified_reference);
}

// The bearings of a planet whose tilt is computed.
void add_seats(PointContent& content, const std::vector<study::SeatResult>& seats) {
  content.add_dimension("bearing", seats.size());
  const auto add = [&](const char* name, const char* units, const char* meaning, const auto& value) {
    content.add_each(name, {"bearing"}, units, meaning, seats, value);
  };
  add("bearing_place", "m", "place along the axis, from the middle of the face", &study::SeatResult::place);
  add("bearing_load", "N", "load of the rollers on the bore", &study::SeatResult::load);
  add("bearing_tilt_x", "rad", "tilt of the bore against the pin, outward",
      [](const study::SeatResult& seat) { return seat.tilt.x(); });
  add("bearing_tilt_y", "rad", "the same, in the sense of rotation",
      [](const study::SeatResult& seat) { return seat.tilt.y(); });
  add("bearing_life", "h", "fatigue life of one bearing", &study::SeatResult::life_hours);
  add_rated_hours(content, "bearing", seats);
}

// Where planets carry unlike loads, or were computed one by one.
void add_planets(PointContent& content, const std::vector<study::PlanetResult>& planets) {
  content.add_dimension("planet", planets.size());
  content.add_each("planet_load_share", {"planet"}, "1",
                   "tangential load of a planet, mean over time, over the mean of all planets", planets,
                   &study::PlanetResult::load_share);
  content.add_each("planet_bearing_load", {"planet"}, "N",
                   "load of the rollers on the bore of one bearing of a planet, mean over time", planets,
                   &study::PlanetResult::load);
  content.add_each("planet_life", {"planet"}, "h", "fatigue life of one bearing of a planet", planets,
                   &study::PlanetResult::life_hours);
  add_rated_hours(content, "planet", planets);
}

// Of a bearing cut into laminae, whose places are those of the distribution.
void add_laminae(PointContent& content, const study::LaminaRecord& record) {
  content.add_dimension("lamina", record.lamina_place.size());
  content.add("lamina_place", {"lamina"}, "m", "middle of a lamina, from the middle of the roller",
              record.lamina_place);
  content.add("inner_lamina_load", {"place", "lamina"}, "N", "load of a lamina of a roller on the inner race",
              record.inner_load);
  content.add("outer_lamina_load", {"place", "lamina"}, "N", "load of a lamina of a roller on the outer race",
              record.outer_load);
  content.add("roller_tilt", {"place"}, "rad", "tilt of a roller, outward at positive lamina places",
              record.roller_tilt);
  const auto add_vector = [&](const std::string& name, const char* units, const std::string& meaning,
                              const Eigen::Vector2d& value) {
    content.add(name + "_x", units, meaning + ", outward", value.x());
    content.add(name + "_y", units, meaning + ", in the sense of rotation", value.y());
  };
  add_vector("bore_tilt", "rad", "inclination of the bore's axis against the pin's", record.bore_tilt);
  add_vector("bore_moment", "N.m", "moment of the rollers on the bore along its tilt", record.moment);
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
                           const std::vector<double>& axis_values, const study::PointResult& result) {
  PointContent content;
  add_scalars(content, leading_columns(), result);
  add_scalars(content, trailing_columns(), result);
  for (std::size_t i = 0; i < header.axes.size(); ++i)
    content.add(variable_name(header.axes[i].column), header.axes[i].units, header.axes[i].meaning,
                axis_values[i]);
  add_sets(content, header.sets, result);
  if (is_computed(result.status) && !result.distribution.angle.empty())
    add_distribution(content, result.distribution);
  if (is_computed(result.status) && result.laminae) add_laminae(content, *result.laminae);
  if (is_computed(result.status) && !result.seats.empty()) add_seats(content, result.seats);
  if (is_computed(result.status) && !result.planets.empty()) add_planets(content, result.planets);
  if (result.dynamic) add_series(result.dynamic->series, content);
  if (result.dynamic) add_final_state(result.dynamic->final_state, result.dynamic->layout, content);
  content.attributes = result_attributes(header, fmt::format("operating point {}", point), result.status);
  if (header.continued) content.attributes.emplace_back("continue", to_string(*header.continued));
  if (!header.sets.empty()) content.attributes.emplace_back("limiting_set", result.limiting_set);
  return content;
}

void add_place_in_sweep(bool refined, const std::optional<Resonance>& resonance, PointContent& content) {
  content.attributes.emplace_back("refined", refined ? "true" : "false");
  if (!resonance) return;
  content.attributes.emplace_back("resonance_kind", resonance->kind);
  content.attributes.emplace_back("resonance_mode", resonance->mode);
  content.add("resonance_frequency", "Hz", "natural frequency of the gear set at the nearest resonance",
              resonance->frequency);
  content.add("resonance_harmonic", "1", "harmonic of the mesh frequency that meets it", resonance->harmonic);
  content.add("resonance_speed", "rad s-1", "input speed at which it does", resonance->speed);
}

std::string netcdf_bytes(const PointContent& content) {
  MemoryFile file;
  std::map<std::string, int> dimensions;
  for (const NamedDimension& dimension : content.dimensions)
    check(nc_def_dim(file.number(), dimension.name.c_str(), dimension.size, &dimensions[dimension.name]));
  std::vector<int> variables;
  for (const NamedArray& array : content.arrays)
    variables.push_back(define(file.number(), array, dimensions));
  for (const auto& [name, text] : content.attributes) put_text(file.number(), NC_GLOBAL, name.c_str(), text);
  check(nc_enddef(file.number()));
  for (std::size_t i = 0; i < variables.size(); ++i)
    check(nc_put_var_double(file.number(), variables[i], content.arrays[i].values.data()));
  return file.bytes();
}

std::vector<double> read_final_state(const std::filesystem::path& file) {
  int number = 0;
  if (nc_open(file.c_str(), NC_NOWRITE, &number) != NC_NOERR) return {};
  int variable = 0;
  int dimension = 0;
  std::size_t size = 0;
  std::vector<double> state;
  if (nc_inq_varid(number, final_state_name, &variable) == NC_NOERR &&
      nc_inq_vardimid(number, variable, &dimension) == NC_NOERR &&
      nc_inq_dimlen(number, dimension, &size) == NC_NOERR) {
    state.resize(size);
    if (nc_get_var_double(number, variable, state.data()) != NC_NOERR) state.clear();
  }
  nc_close(number);
  return state;
}

}  // namespace orbearing::app
