#include "app/interface/case_values.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "app/case/check_table.hpp"
#include "app/case/field_table.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

const Field& field_at(const ResolvedCase& stated, const std::string& path) {
  std::vector<std::string> known;
  for (const Input& input : stated.inputs()) {
    if (input.path == path) return *input.field;
    known.push_back(input.path);
  }
  const std::string near = nearest_word(path, known);
  throw BadInput(fmt::format(
      "{}: {}: found a path that this case does not have{}; required: the path of a value of the case",
      stated.file(), path, near.empty() ? "" : " (did you mean '" + near + "'?)"));
}

const char* kind_name(Kind kind) {
  switch (kind) {
    case Kind::quantity:
      return "quantity";
    case Kind::integer:
      return "integer";
    case Kind::number:
      return "number";
    case Kind::flag:
      return "flag";
    case Kind::choice:
      return "choice";
    case Kind::text:
      return "text";
    case Kind::list:
      return "list";
  }
  return "";
}

Json described(const ResolvedCase& stated, const Input& input) {
  const auto& [path, field] = input;
  const bool given = stated.has(path);
  const auto& assumed = stated.assumed();
  const auto reason = assumed.find(path);
  const bool is_default = given && stated.origin(path) == "default";
  return {{"path", path},
          {"kind", kind_name(field->kind)},
          {"unit", field->dimension.customary},
          {"si_unit", field->dimension.si},
          {"meaning", field->meaning},
          {"given", given ? Json(stated.given(path)) : Json()},
          {"source", !given                    ? "absent"
                     : is_default              ? "default"
                     : reason != assumed.end() ? "assumed"
                                               : "given"},
          {"reason", reason == assumed.end() ? "" : reason->second}};
}

}  // namespace

Json value_of(const ResolvedCase& stated, const std::string& path) {
  const Field& field = field_at(stated, path);
  if (!stated.has(path)) return nullptr;
  described::Record record;
  describe_value(record, stated, {path, &field});
  return json_of(record).at("value");
}

Json given_of(const ResolvedCase& stated, const std::string& path) {
  field_at(stated, path);
  return stated.has(path) ? Json(stated.given(path)) : Json();
}

double number_in_si(const ResolvedCase& stated, const std::string& path, const std::string& text) {
  const Field& field = field_at(stated, path);
  const FieldReading reading = read_field_text(field, text);
  if (!reading.good)
    throw BadInput(
        fmt::format("{}: found {}; required: {}", path, reading.message.found, requirement(field)));
  return reading.value.number;
}

Json si_units(const std::string& path) {
  const Field* field = find_field(path);
  if (field == nullptr) return nullptr;
  Json columns = Json::array();
  for (const ListColumn& column : field->columns)
    columns.push_back(Json::array({column_key(column), column.dimension.si}));
  return Json::array({field->dimension.si, columns});
}

Json inputs_of(const ResolvedCase& stated) {
  Json rows = Json::array();
  for (const Input& input : stated.inputs()) rows.push_back(described(stated, input));
  return rows;
}

Json axes_of(const ResolvedCase& stated) {
  Json axes = Json::object();
  for (const SweepAxis& axis : stated.axes()) axes[axis.path] = axis.values;
  return axes;
}

void advance_until_stopped(Participant& participant, double length) {
  constexpr double long_step = 1e-3;  // [s]  a caller may stop longer ones by Ctrl-C
  std::optional<Interruption> interruption;
  if (length > long_step) interruption.emplace();
  participant.advance(length);
}

}  // namespace orbearing::app
