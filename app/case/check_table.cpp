#include "app/case/check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/case/field_table.hpp"
#include "app/case/unused_inputs.hpp"

namespace orbearing::app {

namespace {

struct Row {
  std::string path;
  std::string value;
  std::string unit;
  std::string status;    // given, assumed or derived
  std::string remark;    // reason or meaning
};

std::string status(const ResolvedCase& resolved, const std::string& path) {
  return resolved.assumed().contains(path) ? "assumed" : "given";
}

std::string reason(const ResolvedCase& resolved, const std::string& path) {
  const auto found = resolved.assumed().find(path);
  if (found != resolved.assumed().end()) return found->second;
  return resolved.origin(path) == "--set" ? "set by an option" : "";
}

Row input_row(const ResolvedCase& resolved, const Input& input) {
  const auto& [path, field] = input;
  Row row{path, resolved.given(path), "", status(resolved, path), reason(resolved, path)};
  if (field->kind == Kind::quantity) {
    row.unit = split_quantity(row.value).value->unit;
    row.value.resize(row.value.rfind(row.unit));
    row.value.erase(row.value.find_last_not_of(' ') + 1);
  }
  return row;
}

std::vector<Row> all_rows(const ResolvedCase& resolved, const std::vector<Derived>& derived) {
  std::vector<Row> rows{{"quantity", "value", "unit", "standing", "reason or meaning"}};
  for (const Input& input : resolved.inputs())
    if (resolved.has(input.path)) rows.push_back(input_row(resolved, input));
  for (const SweepAxis& axis : resolved.axes())
    rows.push_back(
        {"sweep." + axis.path, fmt::format("{} values", axis.values.size()), "", "given", axis.written});
  for (const StatedUncertain& one : resolved.uncertain().inputs)
    rows.push_back({"uncertain." + one.path, one.written, "", "uncertain",
                    "used by uncertainty and validate alone" + (one.reason.empty() ? "" : "; " + one.reason)});
  if (const StatedCorrelations& joined = resolved.uncertain().correlations; !joined.written.empty())
    rows.push_back({"uncertain.correlations", joined.written, "", "uncertain", "of the normal scores"});
  for (const Derived& quantity : derived)
    rows.push_back({quantity.path, fmt::format("{:.6g}", quantity.value),
                    quantity.unit == "1" ? "" : quantity.unit, "derived", quantity.meaning});
  return rows;
}

std::string line(const Row& row, const std::array<std::size_t, 4>& widths) {
  std::string text =
      fmt::format("{:{}}  {:{}}  {:{}}  {:{}}  {}", printable(row.path), widths[0], printable(row.value),
                  widths[1], printable(row.unit), widths[2], row.status, widths[3], printable(row.remark));
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

// Rows as lists; those of which some columns are left out, with the names of what they have.
nlohmann::json rows_of_list(const Field& field, const std::vector<double>& list) {
  const bool some_left_out = has_choices(field);
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < list.size(); i += field.columns.size()) {
    nlohmann::json listed = nlohmann::json::array(), named = nlohmann::json::object();
    for (std::size_t k = 0; k < field.columns.size(); ++k) {
      const ListColumn& column = field.columns[k];
      listed.push_back(list[i + k]);
      if (column.one_of == 0 || list[i + k] != 0.0) named[column_key(column)] = list[i + k];
    }
    rows.push_back(some_left_out ? named : listed);
  }
  return rows;
}

nlohmann::json value_json(const ResolvedCase& resolved, const Input& input) {
  const auto& [path, field] = input;
  switch (field->kind) {
    case Kind::quantity:
      return resolved.quantity(path);
    case Kind::number:
      return resolved.number(path);
    case Kind::integer:
      return resolved.integer(path);
    case Kind::flag:
      return resolved.flag(path);
    case Kind::list:
      if (field->element == Kind::text) return resolved.texts(path);
      if (!field->columns.empty()) return rows_of_list(*field, resolved.list(path));
      return resolved.list(path);
    case Kind::choice:
    case Kind::text:
      break;
  }
  return resolved.given(path);
}

nlohmann::json input_json(const ResolvedCase& resolved, const Input& input) {
  const auto& [path, field] = input;
  nlohmann::json used_by = nlohmann::json::array(), not_felt_by = nlohmann::json::array();
  for (const use::Analysis analysis : analyses_of(resolved)) {
    const UseStatus status = use_status_in_row(resolved, input, analysis);
    if (status == UseStatus::used) used_by.push_back(analysis_name(analysis));
    if (status == UseStatus::unfelt) not_felt_by.push_back(analysis_name(analysis));
  }
  return {{"path", path},
          {"used_by", used_by},
          {"not_felt_by", not_felt_by},
          {"value", value_json(resolved, input)},
          {"unit", field->dimension.si.empty() ? "1" : std::string(field->dimension.si)},
          {"given", resolved.given(path)},
          {"standing", status(resolved, path)},
          {"reason", reason(resolved, path)},
          {"origin", resolved.origin(path)}};
}

// What is given and cannot be felt, analysis by analysis.
std::string unfelt_text(const ResolvedCase& resolved) {
  std::string text;
  for (const use::Analysis analysis : analyses_of(resolved)) {
    std::string line;
    for (const Input& input : resolved.inputs())
      if (resolved.has(input.path) && use_status_of(resolved, input, analysis) == UseStatus::unfelt)
        line += (line.empty() ? "" : ", ") + input.path;
    if (!line.empty()) text += fmt::format("not felt, by nature, by {}: {}\n", analysis_name(analysis), line);
  }
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string check_table(const ResolvedCase& resolved, const std::vector<Derived>& derived) {
  // What is longer than this, such as a name or source, must not push the other columns away. Paths within a
  // set are long and come in numbers.
  constexpr std::array<std::size_t, 4> widest{52, 36, 36, 36};
  const std::vector<Row> rows = all_rows(resolved, derived);
  std::array<std::size_t, 4> widths{};
  for (const Row& row : rows) {
    const std::array<std::size_t, 4> lengths{row.path.size(), row.value.size(), row.unit.size(),
                                             row.status.size()};
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = std::max(widths[i], std::min(lengths[i], widest[i]));
  }
  std::string text;
  for (const Row& row : rows) text += line(row, widths);
  return text + unfelt_text(resolved);
}

nlohmann::json check_json(const ResolvedCase& resolved, const std::vector<Derived>& derived) {
  nlohmann::json inputs = nlohmann::json::array();
  for (const Input& input : resolved.inputs())
    if (resolved.has(input.path)) inputs.push_back(input_json(resolved, input));
  nlohmann::json quantities = nlohmann::json::array();
  for (const Derived& quantity : derived)
    quantities.push_back({{"path", quantity.path},
                          {"value", quantity.value},
                          {"unit", quantity.unit},
                          {"standing", "derived"},
                          {"meaning", quantity.meaning}});
  return {{"name", resolved.text("name")},
          {"model", resolved.choice("model")},
          {"inputs", inputs},
          {"derived", quantities}};
}

}  // namespace orbearing::app
