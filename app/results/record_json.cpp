#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/results/record_writers.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

Json number_json(const described::Entry& entry, described::NumberKind kind, double si) {
  const double value = in_customary_unit(entry.dimension, si);
  if (!std::isfinite(value)) return nullptr;
  if (kind == described::NumberKind::yes_or_no) return value != 0.0;
  return kind == described::NumberKind::whole ? Json(std::llround(value)) : Json(value);
}

// Values of the dimensions from `depth` on, nested; `next` is the index of the next number.
Json nested(const described::Entry& entry, const described::Numbers& numbers, std::size_t depth,
            std::size_t& next) {
  if (depth == numbers.shape.size()) return number_json(entry, numbers.kind, numbers.values[next++]);
  const std::vector<std::string>& labels = numbers.along[depth].labels;
  Json list = labels.empty() ? Json::array() : Json::object();
  for (std::size_t i = 0; i < numbers.shape[depth]; ++i)
    if (labels.empty())
      list.push_back(nested(entry, numbers, depth + 1, next));
    else
      list[labels[i]] = nested(entry, numbers, depth + 1, next);
  return list;
}

Json content_json(const described::Entry& entry) {
  return std::visit(Overloaded{[&](const described::Numbers& numbers) {
                                 std::size_t next = 0;
                                 return nested(entry, numbers, 0, next);
                               },
                               [](const described::Table& table) {
                                 Json rows = Json::array();
                                 for (const Record& row : table.rows) rows.push_back(json_of(row));
                                 return rows;
                               },
                               [](const described::Child& child) { return json_of(child.one.front()); },
                               [](described::Nothing) { return Json(nullptr); },
                               [](const auto& plain) { return Json(plain); }},
                    entry.content);
}

struct UnitOfKey {
  std::string path;  // "mesh_force_N/sun/mean"
  std::string key;   // "mean"
  std::string_view unit;
};

void add_units(const Record& record, const std::string& above, std::vector<UnitOfKey>& units) {
  for (const described::Entry& entry : record.entries()) {
    if (entry.in_files_alone) continue;
    const std::string path = above + entry.name;
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      add_units(child->one.front(), path + "/", units);
    if (const auto* table = std::get_if<described::Table>(&entry.content))
      for (const Record& row : table->rows) add_units(row, path + "/", units);
    const auto* numbers = std::get_if<described::Numbers>(&entry.content);
    if (numbers == nullptr || entry.dimension.customary.empty()) continue;
    if (!entry.name.empty()) units.push_back({path, entry.name, entry.dimension.customary});
    if (!entry.former.empty())
      units.push_back({above + entry.former, entry.former, entry.dimension.customary});
    if (entry.name.empty())
      for (const std::string& label : numbers->along.back().labels)
        units.push_back({above + label, label, entry.dimension.customary});
  }
}

}  // namespace

Json json_of(const Record& record) {
  Json object = Json::object();
  for (const described::Entry& entry : record.entries()) {
    if (entry.in_files_alone) continue;
    if (entry.name.empty())
      object.update(content_json(entry));
    else
      object[entry.name] = content_json(entry);
    if (!entry.former.empty()) object[entry.former] = object[entry.name];
  }
  return object;
}

Json units_of(const Record& record) {
  std::vector<UnitOfKey> all;
  add_units(record, "", all);
  std::map<std::string, std::set<std::string_view>> of_key;
  for (const UnitOfKey& one : all) of_key[one.key].insert(one.unit);
  Json units = Json::object();
  for (const UnitOfKey& one : all) units[of_key.at(one.key).size() == 1 ? one.key : one.path] = one.unit;
  return units;
}

}  // namespace orbearing::app
