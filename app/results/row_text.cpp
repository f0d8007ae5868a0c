#include "app/results/row_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace orbearing::app {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

}  // namespace

std::string csv_head(const TableHead& head) {
  std::string line;
  for (const std::string& name : head.names) line += (line.empty() ? "" : ",") + quoted(name);
  return line + '\n';
}

std::string csv_line(const TableHead& head, const ResultRow& row) {
  std::string line;
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    if (i > 0) line += ',';
    if (i == head.status_place)
      line += quoted(row.status);
    else if (i == head.set_place)
      line += quoted(row.limiting_set);
    else if (std::isfinite(row.values[i]))
      line += fmt::format("{}", row.values[i]);
  }
  return line + '\n';
}

nlohmann::ordered_json row_json(const TableHead& head, const ResultRow& row) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    nlohmann::ordered_json& field = object[head.names[i]];
    if (i == head.status_place)
      field = row.status;
    else if (i == head.set_place)
      field = row.limiting_set;
    else if (std::isfinite(row.values[i]))
      field = row.values[i];
  }
  return object;
}

ResultRow row_from_json(const TableHead& head, const nlohmann::ordered_json& object) {
  ResultRow row;
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    const nlohmann::ordered_json& field = object.at(head.names[i]);
    const bool text = i == head.status_place || i == head.set_place;
    if (i == head.status_place) row.status = field.get<std::string>();
    if (i == head.set_place) row.limiting_set = field.get<std::string>();
    row.values.push_back(text || field.is_null() ? not_given : field.get<double>());
  }
  return row;
}

}  // namespace orbearing::app
