#include "app/results/result_row.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"
#include "bearing/life/rating_record.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::app {

namespace {

using study::PlanetResult;
using study::PointResult;

constexpr double rpm_per_rad_s = 9.549296585513721;  // 30 / pi

/// Messages of libraries may hold line ends or bytes that are not UTF-8; tables and JSON need neither.
std::string without_breaks(const std::string& status) {
  if (status.empty()) return "failed without a reason";
  const nlohmann::json text = status;
  std::string clean =
      nlohmann::json::parse(text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
          .get<std::string>();
  std::replace_if(
      clean.begin(), clean.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return clean;
}

// All columns that a point has by itself.
Record row_of(const PointResult& point) {
  Record record;
  study::describe_row(record, point);
  return record;
}

// Texts have none, and what is not known but the input speed.
void add_numbers(const Record& record, bool known, ResultRow& row) {
  for (const described::Entry& entry : record.entries()) {
    const auto* numbers = std::get_if<described::Numbers>(&entry.content);
    const bool shown = numbers != nullptr && (known || entry.name == input_speed_column);
    row.values.push_back(shown ? in_table_unit(numbers->values.front(), 1.0 / entry.dimension.factor)
                               : not_given);
  }
}

void add_names(const Record& record, const std::string& prefix, TableHead& head) {
  for (const described::Entry& entry : record.entries()) head.names.push_back(prefix + entry.name);
}

void add_set_columns(const std::vector<std::string>& sets, TableHead& head) {
  head.set_place = head.names.size();
  head.names.emplace_back(limiting_set_column);
  for (const std::string& set : sets) add_names(record_of(study::SetResult{}), "sets." + set + ".", head);
}

}  // namespace

TableHead table_head(const std::vector<SweptAxis>& axes, const std::vector<std::string>& sets,
                     bool resonances) {
  TableHead head;
  add_names(row_of(PointResult{}), "", head);
  head.status_location =
      static_cast<std::size_t>(std::ranges::find(head.names, status_column) - head.names.begin());
  head.refined_location = head.names.size();
  head.names.emplace_back(refined_column);
  head.first_axis = head.names.size();
  head.axes = axes.size();
  for (const SweptAxis& axis : axes) head.names.push_back(axis.column);
  if (!sets.empty()) add_set_columns(sets, head);
  if (!resonances) return head;
  head.first_resonance = head.names.size();
  add_names(record_of(Resonance{}), "", head);
  return head;
}

double in_table_unit(double value, double per_unit) {
  return mechanics::in_unit(value, per_unit);
}

double speed_in_rpm(double speed) {
  return in_table_unit(speed, rpm_per_rad_s);
}

namespace {

// A failed point has results of no set.
void add_sets(const PointResult& result, std::size_t sets, ResultRow& row) {
  if (sets == 0) return;
  row.values.push_back(not_given);
  if (row.ok()) row.limiting_set = result.limiting_set;
  for (std::size_t set = 0; set < sets; ++set) {
    const bool known = row.ok() && set < result.sets.size();
    add_numbers(record_of(known ? result.sets[set] : study::SetResult{}), known, row);
  }
}

}  // namespace

ResultRow result_row(const PointResult& result, const std::vector<double>& axis_values,
                     const std::vector<std::string>& sets) {
  ResultRow row;
  row.status = without_breaks(result.status);
  add_numbers(row_of(result), row.ok(), row);
  row.values.push_back(not_given);  // refined
  for (const double value : axis_values) row.values.push_back(in_table_unit(value, 1.0));
  add_sets(result, sets.size(), row);
  if (row.ok()) row.planets = result.planets;
  return row;
}

void add_resonance(const std::optional<Resonance>& resonance, ResultRow& row) {
  add_numbers(record_of(resonance.value_or(Resonance{})), resonance.has_value(), row);
  if (!resonance) return;
  row.resonance_kind = resonance->kind;
  row.resonance_mode = resonance->mode;
}

void describe(Record& record, const Resonance& resonance) {
  namespace dimension = described::dimension;
  record.value("resonance_kind", "of the mode: rotational, translational or planet", resonance.kind);
  record.value("resonance_mode", "its name in the report", resonance.mode);
  record.value("resonance_frequency_Hz", dimension::cycles,
               "natural frequency of the gear set, and harmonic of the mesh, at the nearest resonance",
               resonance.frequency);
  record.value("resonance_harmonic", dimension::ratio, "harmonic of the mesh frequency that meets it",
               resonance.harmonic);
  record.value("resonance_speed_rpm", dimension::angular_speed, "input speed at which it does",
               resonance.speed);
  record.value("resonance_frequency_change_Hz", dimension::cycles,
               "change of that natural frequency from 0.01 % below that speed to 0.01 % above; large where a "
               "roller leaves its load there",
               resonance.change);
}

bool on_one_line(const TableHead& head, const ResultRow& one, const ResultRow& other) {
  const auto first = static_cast<std::ptrdiff_t>(head.first_axis);
  const auto axes = static_cast<std::ptrdiff_t>(head.axes);
  return std::equal(one.values.begin() + first, one.values.begin() + first + axes,
                    other.values.begin() + first);
}

double value_of(const TableHead& head, const ResultRow& row, const std::string& name) {
  const auto location = std::find(head.names.begin(), head.names.end(), name);
  return location == head.names.end() ? not_given
                                      : row.values[static_cast<std::size_t>(location - head.names.begin())];
}

double governing_life_in(const TableHead& head, const ResultRow& row) {
  return value_of(head, row, head.life);
}

const ResultRow* longest_lived(const TableHead& head, std::span<const ResultRow> rows, bool grid_alone) {
  const ResultRow* longest = nullptr;
  double life = 0.0;
  for (const ResultRow& row : rows) {
    if ((grid_alone && row.refined) || !(governing_life_in(head, row) > life)) continue;
    life = governing_life_in(head, row);
    longest = &row;
  }
  return longest;
}

namespace {

/// Member of a row that holds the text of column `i`; null for a column of another kind.
std::string ResultRow::*text_member(const TableHead& head, std::size_t i) {
  if (i == head.status_location) return &ResultRow::status;
  if (i == head.set_place) return &ResultRow::limiting_set;
  if (i == head.first_resonance) return &ResultRow::resonance_kind;
  if (head.first_resonance && i == *head.first_resonance + 1) return &ResultRow::resonance_mode;
  return nullptr;
}

// Gives `take` the cell of column `i`: a text, a yes or no, or a number.
template <class Take>
void take_cell(const TableHead& head, const ResultRow& row, std::size_t i, const Take& take) {
  if (const auto text = text_member(head, i))
    take(row.*text);
  else if (i == head.refined_location)
    take(row.refined);
  else
    take(row.values[i]);
}

}  // namespace

std::string csv_head(const TableHead& head) {
  std::string line;
  for (const std::string& name : head.names) line += (line.empty() ? "" : ",") + csv_field(name);
  return line + '\n';
}

std::string csv_line(const TableHead& head, const ResultRow& row) {
  std::string line;
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    if (i > 0) line += ',';
    take_cell(head, row, i,
              Overloaded{[&](const std::string& text) { line += csv_field(text); },
                         [&](bool yes) { line += yes ? "true" : "false"; },
                         [&](double number) {
                           if (std::isfinite(number)) line += fmt::format("{}", number);
                         }});
  }
  return line + '\n';
}

namespace {

constexpr const char* kPlanets = "planets";

nlohmann::ordered_json planet_json(const PlanetResult& planet) {
  Record record;
  study::describe_planet(record, planet);
  return json_of(record);
}

double number_or_none(const nlohmann::ordered_json& value) {
  return value.is_null() ? not_given : value.get<double>();
}

PlanetResult planet_from_json(const nlohmann::ordered_json& object) {
  PlanetResult planet{.load_share = number_or_none(object.at("load_share")),
                      .load = number_or_none(object.at("bearing_load_N")),
                      .life_hours = number_or_none(object.at("life_h"))};
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    planet.rated_hours.*life.hours = number_or_none(object.at(life.name));
  return planet;
}

}  // namespace

nlohmann::ordered_json row_json(const TableHead& head, const ResultRow& row) {
  auto object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    nlohmann::ordered_json& field = object[head.names[i]];
    take_cell(head, row, i,
              Overloaded{[&](double number) {
                           if (std::isfinite(number)) field = number;
                         },
                         [&](const auto& plain) { field = plain; }});
  }
  for (const PlanetResult& planet : row.planets) object[kPlanets].push_back(planet_json(planet));
  return object;
}

void describe_row(described::Record& record, const TableHead& head, const ResultRow& row) {
  for (std::size_t i = 0; i < head.names.size(); ++i)
    take_cell(head, row, i,
              Overloaded{[&](double number) { record.value(head.names[i], {}, "", number); },
                         [&](const auto& plain) { record.value(head.names[i], "", plain); }});
}

ResultRow row_from_json(const TableHead& head, const nlohmann::ordered_json& object) {
  ResultRow row;
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    const nlohmann::ordered_json& field = object.at(head.names[i]);
    double value = not_given;
    if (const auto text = text_member(head, i))
      row.*text = field.get<std::string>();
    else if (i == head.refined_location)
      row.refined = field.get<bool>();
    else if (!field.is_null())
      value = field.get<double>();
    row.values.push_back(value);
  }
  if (object.contains(kPlanets))
    for (const nlohmann::ordered_json& planet : object.at(kPlanets))
      row.planets.push_back(planet_from_json(planet));
  return row;
}

}  // namespace orbearing::app
