#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "app/results/record_writers.hpp"

namespace orbearing::app {

namespace {

using described::Numbers;

// "N.m/rad" as conventions have it: "N m rad-1".
std::string udunits_of(const described::Dimension& dimension) {
  if (dimension.si.empty()) return "1";
  std::string units;
  bool below = false;
  for (const char c : dimension.si) {
    if (c == '/') below = true;
    units += c == '/' || c == '.' ? ' ' : c;
  }
  const char last = units.back();
  if (!below) return units;
  if (last < '2' || last > '9') return units + "-1";
  return units.substr(0, units.size() - 1) + '-' + last;
}

/// Records of the same form, one for each element of `along`: a missing one is null.
struct Bundle {
  std::vector<const Record*> records;
  std::vector<NamedDimension> along;
  std::string prefix;  // of names of variables
};

class Arrays {
 public:
  explicit Arrays(PointContent& content) : content_(content) {}

  void add(const Bundle& bundle) {
    std::vector<std::string> done;
    for (const Record* record : bundle.records) {
      if (record == nullptr) continue;
      for (const described::Entry& entry : record->entries()) {
        if (std::find(done.begin(), done.end(), entry.name + described::name_without_unit(entry)) !=
            done.end())
          continue;
        done.push_back(entry.name + described::name_without_unit(entry));
        const Same same = same_entries(bundle, entry);
        const auto given = std::ranges::find_if(same, [](const described::Entry* one) {
          return one != nullptr && !std::holds_alternative<described::Nothing>(one->content);
        });
        if (given != same.end()) add(**given, same, bundle);
      }
    }
  }

 private:
  using Same = std::vector<const described::Entry*>;  // of each record; null where it has none

  static Same same_entries(const Bundle& bundle, const described::Entry& one) {
    Same same;
    for (const Record* record : bundle.records) {
      same.push_back(nullptr);
      if (record == nullptr) continue;
      for (const described::Entry& entry : record->entries())
        if (entry.name == one.name && entry.variable == one.variable) same.back() = &entry;
    }
    return same;
  }

  void add(const described::Entry& entry, const Same& same, const Bundle& bundle) {
    const std::string name = bundle.prefix + described::name_without_unit(entry);
    if (const auto* numbers = std::get_if<Numbers>(&entry.content)) {
      add_numbers(name, entry, *numbers, same, bundle);
    } else if (std::holds_alternative<std::string>(entry.content) && bundle.along.size() < 2) {
      content_.attributes.emplace_back(name, joined(same));
    } else if (const auto* table = std::get_if<described::Table>(&entry.content)) {
      add_table(name.empty() ? name : name + "_", *table, same, bundle);
    } else if (std::holds_alternative<described::Child>(entry.content)) {
      Bundle inner{{}, bundle.along, name.empty() ? name : name + "_"};
      for (const described::Entry* one : same) {
        const auto* child = one == nullptr ? nullptr : std::get_if<described::Child>(&one->content);
        inner.records.push_back(child == nullptr ? nullptr : &child->one.front());
      }
      add(inner);
    }
  }

  // "given, assumed": of the rows of a table.
  static std::string joined(const Same& same) {
    std::string texts;
    for (const described::Entry* one : same) {
      const auto* text = one == nullptr ? nullptr : std::get_if<std::string>(&one->content);
      texts += (one == same.front() ? "" : ", ") + (text == nullptr ? std::string() : *text);
    }
    return texts;
  }

  // Rows with different numbers of values are filled up with missing ones.
  void add_table(const std::string& prefix, const described::Table& table, const Same& same,
                 const Bundle& bundle) {
    std::size_t most = 0;
    std::vector<const described::Table*> tables;
    for (const described::Entry* one : same) {
      tables.push_back(one == nullptr ? nullptr : std::get_if<described::Table>(&one->content));
      if (tables.back() != nullptr) most = std::max(most, tables.back()->rows.size());
    }
    if (most == 0) return;
    Bundle inner{{}, bundle.along, prefix};
    inner.along.push_back({table.along, most});
    for (const described::Table* one : tables)
      for (std::size_t i = 0; i < most; ++i)
        inner.records.push_back(one != nullptr && i < one->rows.size() ? &one->rows[i] : nullptr);
    add(inner);
  }

  void add_numbers(const std::string& name, const described::Entry& entry, const Numbers& first,
                   const Same& same, const Bundle& bundle) {
    const Numbers* longest = &first;
    for (const described::Entry* one : same)
      if (const auto* numbers = one == nullptr ? nullptr : std::get_if<Numbers>(&one->content);
          numbers != nullptr && numbers->values.size() > longest->values.size())
        longest = numbers;
    if (longest->values.empty()) return;
    std::vector<double> values;
    for (const described::Entry* one : same) {
      const Numbers* numbers = one == nullptr ? nullptr : std::get_if<Numbers>(&one->content);
      for (std::size_t i = 0; i < longest->values.size(); ++i) {
        const double value =
            numbers != nullptr && i < numbers->values.size() ? numbers->values[i] : not_given;
        values.push_back(std::isfinite(value) ? value : not_given);
      }
    }
    std::vector<NamedDimension> along = bundle.along;
    for (std::size_t i = 0; i < longest->shape.size(); ++i) {
      along.push_back({longest->along[i].name, longest->shape[i]});
      name_elements(longest->along[i]);
    }
    put(name, entry, along, std::move(values));
  }

  void name_elements(const described::Along& along) {
    std::string names;
    for (const std::string& label : along.labels) names += (names.empty() ? "" : " ") + label;
    const auto same = [&](const auto& attribute) { return attribute.first == along.name; };
    if (!names.empty() && std::none_of(content_.attributes.begin(), content_.attributes.end(), same))
      content_.attributes.emplace_back(along.name, names);
  }

  void put(const std::string& name, const described::Entry& entry, const std::vector<NamedDimension>& along,
           std::vector<double> values) {
    NamedArray array{name, {}, udunits_of(entry.dimension), entry.meaning, std::move(values)};
    for (const NamedDimension& dimension : along) {
      array.dimensions.push_back(dimension.name);
      const auto known = std::find_if(content_.dimensions.begin(), content_.dimensions.end(),
                                      [&](const NamedDimension& one) { return one.name == dimension.name; });
      if (known == content_.dimensions.end())
        content_.dimensions.push_back(dimension);
      else if (known->size != dimension.size)
        throw std::logic_error("results: " + name + ": another size of the dimension " + dimension.name);
    }
    content_.arrays.push_back(std::move(array));
  }

  PointContent& content_;
};

// A variable of a dimension's name holds the coordinates along it, by convention: readers refuse others.
bool holds_coordinates(const NamedArray& array) {
  return array.dimensions == std::vector<std::string>{array.name};
}

void rename_dimension(const std::string& from, const std::string& to, PointContent& content) {
  for (NamedDimension& dimension : content.dimensions)
    if (dimension.name == from) dimension.name = to;
  for (NamedArray& array : content.arrays) std::ranges::replace(array.dimensions, from, to);
}

}  // namespace

PointContent content_of(const Record& record) {
  PointContent content;
  Arrays(content).add({{&record}, {}, ""});
  for (const NamedArray& array : content.arrays)
    if (!holds_coordinates(array)) rename_dimension(array.name, array.name + "_index", content);
  return content;
}

}  // namespace orbearing::app
