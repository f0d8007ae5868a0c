#include "app/case/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/case/case_shape.hpp"
#include "app/case/catalogue_fields.hpp"
#include "app/case/catalogue_file.hpp"
#include "app/case/derived_defaults.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/uncertain_case.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

// A number, then a unit; whether the unit fits is beyond a schema.
constexpr const char* quantity_pattern = R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*\S.*$)";

Json with_range(Json schema, const Range& range) {
  if (std::isfinite(range.least)) schema[range.least_allowed ? "minimum" : "exclusiveMinimum"] = range.least;
  if (std::isfinite(range.most)) schema[range.most_allowed ? "maximum" : "exclusiveMaximum"] = range.most;
  return schema;
}

Json object_of(Json properties, Json required) {
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", std::move(required)},
          {"properties", std::move(properties)}};
}

Json cell_schema(const ListColumn& column) {
  const Json number = with_range({{"type", "number"}}, column.range);
  const Json quantity{{"type", "string"}, {"pattern", quantity_pattern}};
  if (column.text) return {{"type", "string"}, {"minLength", 1}};
  if (column.dimension.si.empty()) return number;
  return column.unit_of_number.empty() ? quantity : Json{{"oneOf", {quantity, number}}};
}

// A list of all columns; or a block, with one of those of which a row has one.
Json row_schema(const Field& field) {
  const Json listed{{"type", "array"},
                    {"minItems", field.columns.size()},
                    {"maxItems", field.columns.size()},
                    {"items", {{"type", "string"}, {"pattern", quantity_pattern}}}};
  Json block = object_of(Json::object(), Json::array());
  std::map<int, Json> choices;
  for (const ListColumn& column : field.columns) {
    block["properties"][column_key(column)] = cell_schema(column);
    if (column.optional) continue;
    if (column.one_of == 0)
      block["required"].push_back(column_key(column));
    else
      choices[column.one_of].push_back({{"required", {column_key(column)}}});
  }
  if (choices.empty()) return {{"oneOf", {listed, block}}};
  block["allOf"] = Json::array();
  for (const auto& [group, choice] : choices) block["allOf"].push_back({{"oneOf", choice}});
  return block;
}

// The list itself, or the file that holds it.
Json or_file(const Field& field, Json list) {
  if (!field.from_file) return list;
  const Json file = object_of({{"file", {{"type", "string"}, {"minLength", 1}}}}, {"file"});
  return {{"oneOf", {list, file}}};
}

Json rows_schema(const Field& field) {
  return or_file(field, {{"type", "array"}, {"minItems", 1}, {"items", row_schema(field)}});
}

Json list_schema(const Field& field, const Json& element) {
  Json list{{"type", "array"}, {"minItems", std::max<std::size_t>(1, field.group)}, {"items", element}};
  if (field.group == 0) return or_file(field, list);
  list["maxItems"] = field.group;
  return {{"oneOf", {list, Json{{"type", "array"}, {"minItems", 1}, {"items", list}}}}};
}

Json value_schema(const Field& field, Kind kind) {
  switch (kind) {
    case Kind::quantity:
      return {{"type", "string"}, {"pattern", quantity_pattern}};
    case Kind::integer:
      return with_range({{"type", "integer"}}, field.range);
    case Kind::number:
      return with_range({{"type", "number"}}, field.range);
    case Kind::flag:
      return {{"type", "boolean"}};
    case Kind::choice:
      return {{"type", "string"}, {"enum", field.choices}};
    case Kind::text:
      return {{"type", "string"}, {"minLength", 1}};
    case Kind::list:
      if (!field.columns.empty()) return rows_schema(field);
      return list_schema(field, value_schema(field, field.element));
  }
  return {};
}

Json default_value(const Field& field) {
  const bool text = field.kind == Kind::quantity || field.kind == Kind::choice || field.kind == Kind::text;
  return text ? Json(field.default_text) : Json::parse(field.default_text);
}

// Designations of the built-in catalogue; a user's catalogue file may have others.
std::vector<std::string> built_in_designations() {
  std::vector<std::string> names;
  for (const bearing::catalogue::Entry& entry : built_in_catalogue())
    names.insert(names.end(), entry.designations.begin(), entry.designations.end());
  return names;
}

Json field_schema(const Field& field) {
  Json schema = value_schema(field, field.kind);
  std::string required = requirement(field);
  if (required.ends_with(',')) required.pop_back();
  std::string description = fmt::format("{} ({})", field.meaning, required);
  const std::string_view rule = default_rule(field.path);
  if (!rule.empty()) description += fmt::format("; left out: {}", rule);
  schema["description"] = description;
  if (field.kind == Kind::quantity) schema["examples"] = {field.dimension.example};
  if (field.path.ends_with(keys().designation)) schema["examples"] = built_in_designations();
  if (rule.empty() && !field.default_text.empty()) schema["default"] = default_value(field);
  if (field.numerical) schema["numerical"] = true;
  return schema;
}

Json& block_of(Json& root, std::string_view path, bool required) {
  Json* block = &root;
  for (auto dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    const std::string key(path.substr(0, dot));
    Json& list = (*block)["required"];
    if (required && std::find(list.begin(), list.end(), key) == list.end()) list.push_back(key);
    Json& child = (*block)["properties"][key];
    if (child.is_null()) child = object_of(Json::object(), Json::array());
    block = &child;
    path.remove_prefix(dot + 1);
  }
  return *block;
}

// A ball bearing is one model to a schema, with or without a block `simulation`; so is a scratched bearing of
// balls or rollers.
unsigned kinds_of(Model model) {
  if (model == raceway_defect) return model_sets::single_scratched;
  return model == ball_bearing ? single_ball_bearing : unsigned{model};
}

// Schema of a block with a value at `path` within it, one of `values` if there are any.
Json present(std::string_view path, const std::vector<std::string>& values) {
  const auto dot = path.find('.');
  const std::string key(path.substr(0, dot));
  Json schema{{"required", {key}}};
  if (dot != std::string_view::npos)
    schema["properties"] = {{key, present(path.substr(dot + 1), values)}};
  else if (!values.empty())
    schema["properties"] = {{key, {{"enum", values}}}};
  return schema;
}

// A value that is required unless another one of its block gives it.
void require_or_given(Json& root, const Field& field, const std::vector<Condition>& givers) {
  const std::size_t block = field.path.find('.') + 1;
  Json either = Json::array({present(std::string_view(field.path).substr(block), {})});
  for (const Condition& giver : givers)
    either.push_back(present(std::string_view(giver.paths.front()).substr(block), giver.values));
  block_of(root, field.path.substr(0, block) + "x", true)["allOf"].push_back({{"anyOf", std::move(either)}});
}

void add_field(Json& root, const Field& field, Model model) {
  const bool required = (field.required_by & kinds_of(model)) == kinds_of(model);
  const std::vector<Condition> givers = given_by(field.path);
  if (required && !givers.empty()) require_or_given(root, field, givers);
  const bool always = required && givers.empty();
  Json& block = block_of(root, field.path, always);
  const std::string key = field.path.substr(field.path.rfind('.') + 1);
  if (always) block["required"].push_back(key);
  block["properties"][key] = field_schema(field);
}

Json axis_schema(const Field& field) {
  const Json value = value_schema(field, field.kind);
  Json step = value_schema(field, field.kind);
  for (const char* bound : {"minimum", "maximum", "exclusiveMaximum"}) step.erase(bound);
  if (field.kind != Kind::quantity) step["exclusiveMinimum"] = 0;
  const Json range = object_of({{"from", value}, {"to", value}, {"step", step}}, {"from", "to", "step"});
  const Json list = {{"type", "array"}, {"minItems", 1}, {"uniqueItems", true}, {"items", value}};
  return {{"description", field.meaning}, {"oneOf", {range, list}}};
}

// Names of sets and shafts, as `is_name` has them.
constexpr const char* name_pattern = "[A-Za-z][A-Za-z0-9_]{0,39}";

// The path of a field within a set of any name, as a pattern.
std::string pattern_in_sets(const Field& field) {
  std::string pattern = fmt::format("^sets\\.{}\\.", name_pattern);
  for (const char c : field.path) pattern += c == '.' ? "\\." : std::string(1, c);
  return pattern + "$";
}

// The block `key`: an object with a key for each field's path, in a set as well.
Json by_path(Model model, const char* key, const char* description, bool (*takes)(const Field&),
             Json (*schema)(const Field&)) {
  Json properties = Json::object();
  Json patterns = Json::object();
  for (const Field* field : fields_of(kinds_of(model))) {
    if (!takes(*field)) continue;
    properties[field->path] = schema(*field);
    if ((model & planetary_drivetrain) != 0 && in_each_set(*field))
      patterns[pattern_in_sets(*field)] = {{"$ref", fmt::format("#/$defs/{}/properties/{}/properties/{}",
                                                                model_name(model), key, field->path)}};
  }
  if ((model & planetary_drivetrain) != 0 && takes(shaft_field()))
    patterns[fmt::format("^shafts\\.{}$", name_pattern)] = schema(shaft_field());
  Json block = {{"description", description},
                {"type", "object"},
                {"additionalProperties", false},
                {"properties", properties}};
  if (!patterns.empty()) block["patternProperties"] = patterns;
  return block;
}

Json sweep_schema(Model model) {
  return by_path(model, "sweep", "values that are varied; several axes make every combination", can_be_swept,
                 axis_schema);
}

// One distribution, with or without a reason; ranges of the field are beyond it.
Json distribution_schema(const Json& number, const Json& deviation, bool clearance) {
  Json choices = Json::array();
  const auto choose = [&](const char* key, const Json& schema) {
    choices.push_back(object_of({{key, schema}, {"reason", {{"type", "string"}, {"minLength", 1}}}}, {key}));
  };
  Json normal = object_of({{"mean", number},
                           {"standard_deviation", deviation},
                           {"relative_standard_deviation", {{"type", "number"}, {"exclusiveMinimum", 0}}},
                           {"from", number},
                           {"to", number}},
                          Json::array());
  normal.erase("required");
  normal["oneOf"] = Json::array({Json::object({{"required", Json::array({"standard_deviation"})}}),
                                 Json::object({{"required", Json::array({"relative_standard_deviation"})}})});
  choose("normal", normal);
  choose("uniform", object_of({{"from", number}, {"to", number}}, {"from", "to"}));
  choose("triangular",
         object_of({{"from", number}, {"peak", number}, {"to", number}}, {"from", "peak", "to"}));
  if (clearance)
    choose("class", {{"type", "string"}, {"enum", find_field("bearing.clearance_class")->choices}});
  return {{"oneOf", choices}};
}

void add_distributions(Json& definitions) {
  const Json quantity{{"type", "string"}, {"pattern", quantity_pattern}}, number{{"type", "number"}};
  definitions["uncertain-quantity"] = distribution_schema(quantity, quantity, false);
  definitions["uncertain-clearance"] = distribution_schema(quantity, quantity, true);
  definitions["uncertain-number"] =
      distribution_schema(number, {{"type", "number"}, {"exclusiveMinimum", 0}}, false);
}

Json distribution_of(const Field& field) {
  const Kind kind = field.kind == Kind::list ? field.element : field.kind;
  const char* name = kind == Kind::number                    ? "uncertain-number"
                     : field.path == keys().radial_clearance ? "uncertain-clearance"
                                                             : "uncertain-quantity";
  return {{"$ref", fmt::format("#/$defs/{}", name)}};
}

Json uncertain_schema(Model model) {
  Json schema = by_path(model, "uncertain",
                        "uncertain numbers and their distributions; each element of a list separately",
                        can_be_uncertain, distribution_of);
  const Json row{{"type", "array"}, {"items", {{"type", "number"}, {"minimum", -1}, {"maximum", 1}}}};
  schema["properties"]["correlations"] =
      object_of({{"of", {{"type", "array"}, {"minItems", 1}, {"items", {{"type", "string"}}}}},
                 {"matrix", {{"type", "array"}, {"minItems", 1}, {"items", row}}}},
                {"of", "matrix"});
  return schema;
}

Json assumed_schema(Model model) {
  return by_path(
      model, "assumed", "reasons for values that the source does not give", [](const Field&) { return true; },
      [](const Field&) {
        return Json{{"type", "string"}, {"minLength", 1}};
      });
}

Json named_blocks(const char* description, Json block) {
  return {{"description", description},
          {"type", "object"},
          {"additionalProperties", false},
          {"minProperties", 1},
          {"patternProperties", {{fmt::format("^{}$", name_pattern), std::move(block)}}}};
}

Json with(const char* key) {
  return {{"required", {key}}};
}

// One set with teeth, with or without a bearing; one set of masses and stiffnesses; several sets.
void add_shapes(Json& schema) {
  Json& gearset = schema["properties"]["gearset"];
  Json toothed = {{"required", gearset["required"]}};
  Json toothless = {{"required", {"dynamics"}}, {"not", with("teeth")}};
  gearset["required"] = {"planets"};
  schema["oneOf"] = {{{"required", {"input", "gearset"}}, {"properties", {{"gearset", std::move(toothed)}}}},
                     {{"required", {"gearset"}},
                      {"properties", {{"gearset", std::move(toothless)}}},
                      {"not", with("bearing")}},
                     {{"required", {"input", "sets", "shafts"}}}};
}

// Either the fields of one set at the top, or several sets and their shafts.
void add_multi_stage(Json& schema) {
  Json set = object_of(Json::object(), Json::array());
  for (const Field& field : all_fields())
    if (in_each_set(field)) add_field(set, field, planetary_drivetrain);
  Json& with_bearing = set["required"];  // a set may go without bearings
  with_bearing.erase(std::find(with_bearing.begin(), with_bearing.end(), "bearing"));
  schema["properties"]["sets"] = named_blocks("planetary sets by name", std::move(set));
  schema["properties"]["shafts"] =
      named_blocks("parts that rotate together, by name", field_schema(shaft_field()));
  Json& required = schema["required"];
  for (const char* key : {"gearset", "bearing", "input"})
    required.erase(std::find(required.begin(), required.end(), key));
  add_shapes(schema);
}

Json model_schema(Model model) {
  Json schema = object_of(Json::object(), Json::array());
  for (const Field* field : fields_of(kinds_of(model))) add_field(schema, *field, model);
  schema["properties"]["model"] = {{"const", model_name(model)}};
  if (model == planetary_drivetrain) schema["properties"]["sweep"] = sweep_schema(model);
  schema["properties"]["uncertain"] = uncertain_schema(model);
  schema["properties"]["assumed"] = assumed_schema(model);
  if (model == planetary_drivetrain) add_multi_stage(schema);
  return schema;
}

}  // namespace

std::string case_schema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "Orbearing case"},
                 {"type", "object"},
                 {"required", {"name", "model"}},
                 {"properties", {{"model", field_schema(*find_field("model"))}}},
                 {"allOf", Json::array()},
                 {"$defs", Json::object()}};
  for (const Model model : models()) {
    const std::string name(model_name(model));
    schema["allOf"].push_back(
        {{"if", {{"properties", {{"model", {{"const", name}}}}}, {"required", {"model"}}}},
         {"then", {{"$ref", "#/$defs/" + name}}}});
    schema["$defs"][name] = model_schema(model);
  }
  add_distributions(schema["$defs"]);
  return schema.dump(2) + "\n";
}

}  // namespace orbearing::app
