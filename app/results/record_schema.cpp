#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using described::NumberKind;

const char* type_of(NumberKind kind) {
  return kind == NumberKind::real ? "number" : kind == NumberKind::whole ? "integer" : "boolean";
}

// Along labelled dimensions an object has a key for each label.
Json numbers_schema(const described::Numbers& numbers) {
  Json schema{{"type", {type_of(numbers.kind), "null"}}};
  for (auto along = numbers.along.rbegin(); along != numbers.along.rend(); ++along)
    schema = along->labels.empty() ? Json{{"type", {"array"}}, {"items", std::move(schema)}}
                                   : Json{{"type", {"object"}}, {"additionalProperties", std::move(schema)}};
  if (!numbers.along.empty()) schema["dimensions"] = described::each(numbers.along, &described::Along::name);
  return schema;
}

Json table_schema(const described::Table& table) {
  Json schema{{"type", {"array"}}, {"dimensions", {table.along}}};
  for (const Record& row : table.rows) extend_schema(schema, {{"items", schema_of(row)}});
  return schema;
}

Json content_schema(const described::Entry& entry) {
  if (const auto* numbers = std::get_if<described::Numbers>(&entry.content)) return numbers_schema(*numbers);
  if (const auto* table = std::get_if<described::Table>(&entry.content)) return table_schema(*table);
  if (const auto* child = std::get_if<described::Child>(&entry.content)) return schema_of(child->one.front());
  if (std::holds_alternative<described::Texts>(entry.content))
    return {{"type", {"array"}}, {"items", {{"type", {"string"}}}}};
  return {{"type", {std::holds_alternative<std::string>(entry.content) ? "string" : "null"}}};
}

Json entry_schema(const described::Entry& entry) {
  Json schema = content_schema(entry);
  schema["description"] = entry.meaning;
  if (!entry.dimension.customary.empty()) schema["unit"] = entry.dimension.customary;
  if (!entry.symbol.empty()) schema["symbol"] = entry.symbol;
  return schema;
}

}  // namespace

Json schema_of(const Record& record) {
  Json properties = Json::object();
  for (const described::Entry& entry : record.entries()) {
    if (entry.in_files_alone) continue;
    if (!entry.name.empty()) {
      properties[entry.name] = entry_schema(entry);
      if (!entry.former.empty()) properties[entry.former] = properties[entry.name];
      continue;
    }
    const described::Along& last = std::get<described::Numbers>(entry.content).along.back();
    for (const std::string& label : last.labels)
      properties[label] = entry_schema({label, entry.dimension, entry.meaning, described::Numbers{}});
  }
  return {{"type", {"object"}}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

void extend_schema(Json& schema, const Json& other) {
  for (const auto& [key, value] : other.items()) {
    if (!schema.contains(key)) {
      schema[key] = value;
    } else if (value.is_object()) {
      extend_schema(schema[key], value);
    } else if (key == "type") {
      for (const Json& type : value)
        if (std::find(schema[key].begin(), schema[key].end(), type) == schema[key].end())
          schema[key].push_back(type);
    }
  }
}

}  // namespace orbearing::app
