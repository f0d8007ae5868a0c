#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"
#include "app/results/result_row.hpp"

namespace orbearing::app {

namespace {

using described::Entry;
using Json = nlohmann::ordered_json;

template <class... Callables>
struct Overloaded : Callables... {
  using Callables::operator()...;
};
template <class... Callables>
Overloaded(Callables...) -> Overloaded<Callables...>;

Json number_json(const described::Dimension& dimension, double si) {
  const double value = in_customary_unit(dimension, si);
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// Of the dimensions from `depth` on; `next` is the first number not yet taken.
Json nested(const Entry& entry, const described::Numbers& numbers, std::size_t depth, std::size_t& next) {
  if (depth == numbers.shape.size()) return number_json(entry.dimension, numbers.values[next++]);
  const std::vector<std::string>& labels = numbers.along[depth].labels;
  Json list = labels.empty() ? Json::array() : Json::object();
  for (std::size_t i = 0; i < numbers.shape[depth]; ++i)
    if (labels.empty())
      list.push_back(nested(entry, numbers, depth + 1, next));
    else
      list[labels[i]] = nested(entry, numbers, depth + 1, next);
  return list;
}

Json content_json(const Entry& entry) {
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

void add_units(const Record& record, Json& units) {
  for (const Entry& entry : record.entries()) {
    if (const auto* child = std::get_if<described::Child>(&entry.content))
      add_units(child->one.front(), units);
    if (const auto* table = std::get_if<described::Table>(&entry.content))
      for (const Record& row : table->rows) add_units(row, units);
    const auto* numbers = std::get_if<described::Numbers>(&entry.content);
    if (numbers == nullptr || entry.in_files_alone) continue;
    if (!entry.name.empty())
      units[entry.name] = entry.dimension.customary;
    else
      for (const std::string& label : numbers->along.back().labels) units[label] = entry.dimension.customary;
  }
}

}  // namespace

double in_customary_unit(const described::Dimension& dimension, double value) {
  return in_table_unit(value, 1.0 / dimension.factor);
}

Json json_of(const Record& record) {
  Json object = Json::object();
  for (const Entry& entry : record.entries()) {
    if (entry.in_files_alone) continue;
    if (entry.name.empty())
      object.update(content_json(entry));
    else
      object[entry.name] = content_json(entry);
  }
  return object;
}

Json units_of(const Record& record) {
  Json units = Json::object();
  add_units(record, units);
  return units;
}

}  // namespace orbearing::app
