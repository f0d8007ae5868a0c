// Records of results (mechanics/record.hpp) in the forms in which they leave the program.
//
// One rule for values that there are none of: null in JSON, an empty field in CSV, the fill value in files of
// arrays, "-" in text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/number_text.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// One function for values of several types.
template <class... Callables>
struct Overloaded : Callables... {
  using Callables::operator()...;
};
template <class... Callables>
Overloaded(Callables...) -> Overloaded<Callables...>;

// Content of a file of results: named dimensions and arrays, units on every variable.

struct NamedDimension {
  std::string name;
  std::size_t size = 0;  // at least 1
};

/// Values in the order of the dimensions, the last fastest; no dimension: a single value.
struct NamedArray {
  std::string name;
  std::vector<std::string> dimensions;
  std::string units;  // as udunits reads it
  std::string meaning;
  std::vector<double> values;  // NaN where there is none
};

/// All that a file holds; a new series is one more array here.
struct PointContent {
  std::vector<NamedDimension> dimensions;
  std::vector<NamedArray> arrays;
  std::vector<std::pair<std::string, std::string>> attributes;

  void add(std::string name, std::string units, std::string meaning, double value) {
    arrays.push_back({std::move(name), {}, std::move(units), std::move(meaning), {value}});
  }
};

using described::Record;

/// The value of a column that has none.
inline constexpr double not_given = described::kAbsent;

/// Dimensions of numbers that are stored in the unit in which they are shown.
inline constexpr described::Dimension in_rpm{"angular speed", "rpm", "rpm", ""};
inline constexpr described::Dimension in_million_revolutions{"revolutions", "Mrev", "Mrev", ""};

/// All that a result describes.
template <class Result>
Record record_of(const Result& result) {
  Record record;
  describe(record, result);
  return record;
}

/// The single number of that name, as it is held; absent where there is none.
inline double number_in(const Record& record, std::string_view name) {
  const auto found = std::ranges::find(record.entries(), name, &described::Entry::name);
  return found == record.entries().end() ? described::kAbsent
                                         : std::get<described::Numbers>(found->content).values.front();
}

/// Numbers in their customary units. What is for files alone is left out.
nlohmann::ordered_json json_of(const Record& record);
/// Unit of each number in that object by its key; "1" of a ratio. Where keys of one name have several units,
/// by the path: "mesh_force_N/sun/mean".
nlohmann::ordered_json units_of(const Record& record);

/// JSON Schema of that object: of each value its type, unit, meaning, dimensions and symbol.
nlohmann::ordered_json schema_of(const Record& record);
/// Adds what another record of the same kind has besides.
void extend_schema(nlohmann::ordered_json& schema, const nlohmann::ordered_json& other);

/// The same for terminals: a line for each value, tables, longer lists by their range.
std::string text_of(const Record& record);

/// A text as a field of RFC 4180, in quotes where it needs them.
std::string csv_field(const std::string& text);
/// A table as lines of RFC 4180, ended by "\n", with structures and labelled numbers of its rows as columns;
/// of a structure its arrays as columns, a line for each element of the largest.
std::string csv_of(const described::Entry& table);

/// Arrays and single numbers in SI, texts as attributes, those of a table joined; its rows along its
/// dimension.
PointContent content_of(const Record& record);

/// Names and single values of a record as lines of a table.
std::string csv_names(const Record& record);
std::string csv_values(const Record& record);

/// `value` x `per_unit` to 15 significant digits, which is what a conversion leaves of a double; so that
/// 6000 rpm, held as rad/s, is 6000 rpm again. What is not finite is absent.
inline double in_table_unit(double value, double per_unit) {
  return mechanics::in_unit(value, per_unit);
}
/// A number [SI] in the customary unit, likewise.
inline double in_customary_unit(const described::Dimension& dimension, double value) {
  return in_table_unit(value, 1.0 / dimension.factor);
}
/// A speed [rad/s] as results show speeds [rpm].
inline double speed_in_rpm(double speed) {
  return in_customary_unit(described::dimension::angular_speed, speed);
}

}  // namespace orbearing::app
