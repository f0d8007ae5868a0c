#include "app/results/result_row.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"

namespace orbearing::app {
namespace {

using study::PointResult;

constexpr double rpm_per_rad_s = 9.549296585513721;  // 30 / pi

/// Messages of libraries may hold line ends or bytes that are not UTF-8; tables and JSON need neither.
std::string printable(const std::string& status) {
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
  if (!std::isfinite(value)) return not_given;
  if (per_unit == 1.0) return value;
  constexpr int digits_after_first = 14;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value * per_unit, std::chars_format::scientific,
                                 digits_after_first)
                       .ptr;
  double rounded = not_given;
  std::from_chars(text, end, rounded);
  return std::isfinite(rounded) ? rounded : not_given;
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
  row.status = printable(result.status);
  add_numbers(row_of(result), row.ok(), row);
  row.values.push_back(not_given);  // refined
  for (const double value : axis_values) row.values.push_back(in_table_unit(value, 1.0));
  add_sets(result, sets.size(), row);
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
               "natural frequency of the gear set at the nearest resonance", resonance.frequency);
  record.value("resonance_harmonic", dimension::ratio, "harmonic of the mesh frequency that meets it",
               resonance.harmonic);
  record.value("resonance_speed_rpm", dimension::angular_speed, "input speed at which it does",
               resonance.speed);
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

double life_to_go_by(const TableHead& head, const ResultRow& row) {
  return value_of(head, row, head.life);
}

}  // namespace orbearing::app
