#include "app/case/check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

struct Row {
  std::string path;
  std::string value;
  std::string unit;
  std::string status;  // given, assumed or derived
  std::string remark;  // reason or meaning
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
    rows.push_back(
        {"uncertain." + one.path, one.written, "", "uncertain",
         "used by uncertainty and validate alone" + (one.reason.empty() ? "" : "; " + one.reason)});
  if (const StatedCorrelations& joined = resolved.uncertain().correlations; !joined.written.empty())
    rows.push_back({"uncertain.correlations", joined.written, "", "uncertain", "of the normal scores"});
  for (const Derived& quantity : derived)
    rows.push_back({quantity.path, std::isnan(quantity.value) ? "-" : fmt::format("{:.6g}", quantity.value),
                    quantity.unit == "1" ? "" : quantity.unit, "derived", quantity.meaning});
  return rows;
}

// Beginning of a long value, e.g. of a table within a case.
std::string shortened(const std::string& value) {
  constexpr std::size_t most = 120;
  const std::string text = printable(value);
  return text.size() <= most ? text : text.substr(0, most) + " ... (all with --json)";
}

std::string line(const Row& row, const std::array<std::size_t, 4>& widths) {
  std::string text =
      fmt::format("{:{}}  {:{}}  {:{}}  {:{}}  {}", printable(row.path), widths[0], shortened(row.value),
                  widths[1], printable(row.unit), widths[2], row.status, widths[3], printable(row.remark));
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

using described::Record;

// A list as lists of so many.
std::vector<std::vector<double>> in_rows(const std::vector<double>& list, std::size_t columns) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < list.size(); i += columns)
    rows.emplace_back(list.begin() + static_cast<std::ptrdiff_t>(i),
                      list.begin() + static_cast<std::ptrdiff_t>(i + columns));
  return rows;
}

// Rows as lists; those of which some columns are left out, with the names of what they have.
void describe_rows(Record& record, const Field& field, const FieldValue& value) {
  const std::size_t columns = field.columns.size();
  const std::vector<std::vector<double>> rows = in_rows(value.list, columns);
  if (!has_choices(field)) {
    record.array("value", {}, "in SI", {"row", "column"}, rows);
    return;
  }
  record.table("value", "row", "in SI", rows, [&](Record& row, const std::vector<double>& numbers) {
    for (std::size_t k = 0; k < columns; ++k)
      if (const ListColumn& column = field.columns[k];
          (column.one_of == 0 && !column.optional) || numbers[k] != 0.0) {
        if (column.text)
          row.value(column_key(column), "", text_numbered(value.texts, numbers[k]));
        else
          row.value(column_key(column), {}, "", numbers[k]);
      }
  });
}

std::string si_unit(const Field& field) {
  return field.dimension.si.empty() ? "1" : std::string(field.dimension.si);
}

void describe_input(Record& row, const ResolvedCase& resolved, const Input& input) {
  described::Texts used_by, not_modelled_by;
  for (const AnalysisId analysis : analyses_of(resolved)) {
    const UseStatus status = use_status_in_row(resolved, input, analysis);
    if (status == UseStatus::used) used_by.push_back(analysis_name(analysis));
    if (status == UseStatus::not_modelled) not_modelled_by.push_back(analysis_name(analysis));
  }
  row.value("path", "key of the case", input.path);
  row.value("used_by", "analyses", used_by);
  row.value("not_modelled_by", "analyses", not_modelled_by).former = "not_felt_by";
  describe_value(row, resolved, input);
  row.value("unit", "of the value", si_unit(*input.field));
  row.value("given", "as the case states it", resolved.given(input.path));
  row.value("standing", "given or assumed", status(resolved, input.path));
  row.value("reason", "of what is assumed", reason(resolved, input.path));
  row.value("origin", "location in the case", resolved.origin(input.path));
}

// Given inputs that are not modelled, for each analysis.
std::string not_modelled_text(const ResolvedCase& resolved) {
  std::string text;
  for (const AnalysisId analysis : analyses_of(resolved)) {
    std::string line;
    for (const Input& input : resolved.inputs())
      if (resolved.has(input.path) && use_status_of(resolved, input, analysis) == UseStatus::not_modelled)
        line += (line.empty() ? "" : ", ") + input.path;
    if (!line.empty()) text += fmt::format("not modelled by {}: {}\n", analysis_name(analysis), line);
  }
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::vector<Derived> or_reason(const std::string& path,
                               const std::function<std::vector<Derived>()>& compute) {
  try {
    return compute();
  } catch (const BadInput&) {
    throw;
  } catch (const std::exception& error) {
    return {
        {path, std::numeric_limits<double>::quiet_NaN(), "1", std::string("not computed: ") + error.what()}};
  }
}

std::string check_table(const ResolvedCase& resolved, const std::vector<Derived>& derived) {
  // Longer values, such as a name or source, must not shift the other columns. Paths within a set are long
  // and numerous.
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
  return text + not_modelled_text(resolved);
}

void describe_value(Record& record, const ResolvedCase& resolved, const Input& input) {
  const auto& [path, field] = input;
  const auto add = [&](const auto& plain) { record.value("value", "as given", plain); };
  switch (field->kind) {
    case Kind::quantity:
      record.value("value", {}, "in SI", resolved.quantity(path));
      return;
    case Kind::number:
      record.value("value", {}, "in SI", resolved.number(path));
      return;
    case Kind::integer:
      return add(resolved.integer(path));
    case Kind::flag:
      return add(resolved.flag(path));
    case Kind::list:
      if (field->element == Kind::text) return add(resolved.texts(path));
      if (!field->columns.empty()) return describe_rows(record, *field, resolved.value(path));
      if (field->group > 0 && resolved.list(path).size() > field->group)
        record.array("value", {}, "in SI", {"row", "column"}, in_rows(resolved.list(path), field->group));
      else
        record.array("value", {}, "in SI", {"element"}, resolved.list(path));
      if (field->element == Kind::integer)
        std::get<described::Numbers>(record.entry("value").content).kind = described::NumberKind::whole;
      return;
    case Kind::choice:
    case Kind::text:
      return add(resolved.given(path));
  }
}

void describe_check(Record& record, const ResolvedCase& resolved, const std::vector<Derived>& derived) {
  std::vector<Input> inputs = resolved.inputs();
  std::erase_if(inputs, [&](const Input& input) { return !resolved.has(input.path); });
  record.value("name", "of the case", resolved.text("name"));
  record.value("model", "what is computed", resolved.choice("model"));
  record.table("inputs", "input", "what the case states", inputs,
               [&](Record& row, const Input& input) { describe_input(row, resolved, input); });
  record.table("derived", "quantity", "derived quantities", derived, [](Record& row, const Derived& one) {
    row.value("path", "name", one.path);
    row.value("value", {}, "in its unit", one.value);
    row.value("unit", "of the value", one.unit);
    row.value("standing", "derived", "derived");
    row.value("meaning", "of the quantity", one.meaning);
  });
}

std::map<std::string, std::string> check_units(const ResolvedCase& resolved,
                                               const std::vector<Derived>& derived) {
  std::map<std::string, std::string> units;
  for (const auto& [path, field] : resolved.inputs())
    if (resolved.has(path) && is_numeric(*field)) units[path] = si_unit(*field);
  for (const Derived& one : derived) units[one.path] = one.unit;
  return units;
}

}  // namespace orbearing::app
