#include "app/results/row_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"

namespace orbearing::app {
namespace {

/// Where a row keeps the text of column `i`; null for a column of another kind.
std::string ResultRow::*text_member(const TableHead& head, std::size_t i) {
  if (i == head.status_location) return &ResultRow::status;
  if (i == head.set_place) return &ResultRow::limiting_set;
  if (i == head.first_resonance) return &ResultRow::resonance_kind;
  if (head.first_resonance && i == *head.first_resonance + 1) return &ResultRow::resonance_mode;
  return nullptr;
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
    if (const auto text = text_member(head, i))
      line += csv_field(row.*text);
    else if (i == head.refined_location)
      line += row.refined ? "true" : "false";
    else if (std::isfinite(row.values[i]))
      line += fmt::format("{}", row.values[i]);
  }
  return line + '\n';
}

nlohmann::ordered_json row_json(const TableHead& head, const ResultRow& row) {
  described::Record record;
  describe_row(record, head, row);
  return json_of(record);
}

void describe_row(described::Record& record, const TableHead& head, const ResultRow& row) {
  for (std::size_t i = 0; i < head.names.size(); ++i)
    if (const auto text = text_member(head, i))
      record.value(head.names[i], "", row.*text);
    else if (i == head.refined_location)
      record.value(head.names[i], "", row.refined);
    else
      record.value(head.names[i], {}, "", row.values[i]);
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
  return row;
}

}  // namespace orbearing::app
