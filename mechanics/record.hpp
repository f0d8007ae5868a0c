// Descriptions of results: each value once, next to the structure of results that holds it.
// JSON, CSV, files of arrays, text and the numbers that rows of validation point at all come from the record
// which `describe(record, result)` fills; only the writers of records contain formats.
//
//     inline void describe(described::Record& record, const Shaft& shaft) {
//       using namespace described;
//       record.value("mass_kg", dimension::mass, "of the shaft with all that moves with it", shaft.mass);
//     }
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "mechanics/described.hpp"

namespace orbearing::described {

namespace dimension {
// Dimensions of results only, or with another unit than that of inputs.
inline constexpr Dimension ratio{"ratio", "1", "1", ""};
inline constexpr Dimension percent{"ratio", "1", "percent", "", 0.01};
inline constexpr Dimension small_angle{"angle", "rad", "mrad", "", 1e-3};
inline constexpr Dimension pressure{"pressure", "Pa", "MPa", "", 1e6};
inline constexpr Dimension cycles{"frequency", "Hz", "Hz", ""};
inline constexpr Dimension inverse_mass{"inverse mass", "kg-1", "kg-1", ""};
inline constexpr Dimension growth{"rate", "s-1", "s-1", ""};
inline constexpr Dimension hours{"time", "h", "h", ""};
inline constexpr Dimension revolutions{"revolutions", "revolution", "Mrev", "", 1e6};
inline constexpr Dimension heat{"power", "W", "W", ""};
inline constexpr Dimension small_torque{"torque", "N.m", "N.mm", "", 1e-3};
inline constexpr Dimension acceleration{"acceleration", "m/s2", "m/s2", ""};
inline constexpr Dimension curvature{"curvature", "m-1", "mm-1", "", 1e3};
inline constexpr Dimension race_compliance{"compliance", "m/N", "m/N", ""};
inline constexpr Dimension tooth_stiffness{"stiffness by width", "Pa", "N/(mm.um)", "", 1e9};
}  // namespace dimension

/// Marks a missing value. Every value that is not finite counts as missing.
inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// One dimension of an array: its name, and where they have some the names of its elements.
struct Along {
  Along(std::string of) : name(std::move(of)) {}
  Along(const char* of) : name(of) {}
  Along(std::string of, std::vector<std::string> names) : name(std::move(of)), labels(std::move(names)) {}

  std::string name;
  std::vector<std::string> labels;
};

enum class NumberKind { real, whole, yes_or_no };

/// Numbers [SI] in the order of their dimensions, the last fastest; a single one has no dimension.
struct Numbers {
  std::vector<Along> along{};
  std::vector<std::size_t> shape{};
  std::vector<double> values{};
  NumberKind kind = NumberKind::real;
};

class Record;

/// Rows of one kind, each a record of its own.
struct Table {
  std::string along;  // what its rows are counted by
  std::vector<Record> rows;
};
/// A structure within a structure.
struct Child {
  std::vector<Record> one;  // that has one element
};
struct Nothing {};
using Texts = std::vector<std::string>;
using Content = std::variant<Nothing, Numbers, std::string, Texts, Table, Child>;

/// One value with all that is known of it.
struct Entry {
  std::string name;  // key, with the unit it is shown in at its end: contact_load_max_N
  Dimension dimension;
  std::string meaning;
  Content content;
  std::string symbol{};                   // of the standard that has one
  std::string former{};                   // a key that JSON keeps as well through 1.x
  std::optional<std::string> variable{};  // in files of arrays; none: `name` less its unit
  bool in_files_alone = false;            // what is too long to print
  bool detail = false;                    // what text leaves out
  std::string file{};                     // of a table in a folder of results; none: none
};

// "N.m/rad" at the end of a key: "_N_m_per_rad", or "_N_m_rad".
inline std::string at_end_of_key(std::string_view unit, std::string_view over) {
  std::string end = "_";
  for (const char c : unit)
    if (c == '/')
      end += over;
    else
      end += c == '.' ? '_' : c;
  return end;
}

// The entry's own, or its key less the unit at its end.
inline std::string name_without_unit(const Entry& entry) {
  if (entry.variable) return *entry.variable;
  for (const std::string_view over : {"_per_", "_"})
    if (const std::string end = at_end_of_key(entry.dimension.customary, over);
        end.size() > 1 && entry.name.size() > end.size() && entry.name.ends_with(end))
      return entry.name.substr(0, entry.name.size() - end.size());
  return entry.name;
}

class Record {
 public:
  /// A number [SI].
  Entry& value(std::string name, const Dimension& dimension, std::string meaning, double value) {
    return add(std::move(name), dimension, std::move(meaning), Numbers{.values = {value}});
  }
  Entry& value(std::string name, const Dimension& dimension, std::string meaning,
               const std::optional<double>& value) {
    return this->value(std::move(name), dimension, std::move(meaning), value.value_or(kAbsent));
  }
  /// A count, a yes or no, a text or several.
  template <class Plain>
  Entry& value(std::string name, std::string meaning, const Plain& plain) {
    return add(std::move(name), {}, std::move(meaning), plain_content(plain));
  }

  /// Numbers along dimensions: a range, one of ranges, a vector or a matrix. Without a name, the labels of
  /// its last dimension are listed among the other names.
  template <class Values>
  Entry& array(std::string name, const Dimension& dimension, std::string meaning, std::vector<Along> along,
               const Values& values) {
    Numbers numbers{.along = std::move(along)};
    numbers.shape.resize(numbers.along.size());
    append(values, 0, numbers);
    return add(std::move(name), dimension, std::move(meaning), std::move(numbers));
  }
  /// The same for long arrays, which go to files only.
  template <class Values>
  Entry& series(std::string name, const Dimension& dimension, std::string meaning, std::vector<Along> along,
                const Values& values) {
    Entry& entry = array(std::move(name), dimension, std::move(meaning), std::move(along), values);
    entry.in_files_alone = true;
    return entry;
  }

  /// A row for each of `items`, by `describe` of the item or by `fill(row, item)`.
  template <class Items, class Fill>
  Entry& table(std::string name, std::string along, std::string meaning, const Items& items,
               const Fill& fill) {
    Table table{std::move(along), {}};
    for (const auto& item : items) fill(table.rows.emplace_back(), item);
    return add(std::move(name), {}, std::move(meaning), std::move(table));
  }
  template <class Items>
  Entry& table(std::string name, std::string along, std::string meaning, const Items& items) {
    return table(std::move(name), std::move(along), std::move(meaning), items,
                 [](Record& row, const auto& item) { describe(row, item); });
  }

  /// A missing entry.
  Entry& nothing(std::string name, std::string meaning) {
    return add(std::move(name), {}, std::move(meaning), Nothing{});
  }

  /// A structure within this one, likewise; none of an optional one: nothing.
  template <class Part, class Fill>
  Entry& child(std::string name, std::string meaning, const Part& part, const Fill& fill) {
    if constexpr (is_optional<Part>) {
      if (!part) return nothing(std::move(name), std::move(meaning));
      return child(std::move(name), std::move(meaning), *part, fill);
    } else {
      Child child{std::vector<Record>(1)};
      fill(child.one.front(), part);
      return add(std::move(name), {}, std::move(meaning), std::move(child));
    }
  }
  template <class Part>
  Entry& child(std::string name, std::string meaning, const Part& part) {
    return child(std::move(name), std::move(meaning), part,
                 [](Record& record, const auto& one) { describe(record, one); });
  }

  const std::vector<Entry>& entries() const { return entries_; }
  /// The one called so, which is there.
  Entry& entry(std::string_view name) {
    return *std::ranges::find_if(entries_, [&](const Entry& one) { return one.name == name; });
  }

 private:
  Entry& add(std::string name, const Dimension& dimension, std::string meaning, Content content) {
    return entries_.emplace_back(Entry{std::move(name), dimension, std::move(meaning), std::move(content)});
  }

  template <class Plain>
  static Content plain_content(const Plain& plain) {
    if constexpr (std::is_integral_v<Plain>)
      return Numbers{.values = {static_cast<double>(plain)},
                     .kind = std::is_same_v<Plain, bool> ? NumberKind::yes_or_no : NumberKind::whole};
    else if constexpr (std::is_same_v<Plain, Texts>)
      return plain;
    else
      return std::string(plain);
  }

  template <class Values>
  static void append(const Values& values, std::size_t depth, Numbers& numbers) {
    if constexpr (std::is_arithmetic_v<Values>) {
      numbers.values.push_back(static_cast<double>(values));
    } else if constexpr (requires {
                           values.rowwise();
                           requires !Values::IsVectorAtCompileTime;
                         }) {
      for (const auto& row : values.rowwise()) append(row, depth + 1, numbers);
      numbers.shape[depth] = static_cast<std::size_t>(values.rows());
    } else {
      for (const auto& value : values) append(value, depth + 1, numbers);
      numbers.shape[depth] = static_cast<std::size_t>(values.size());
    }
  }

  std::vector<Entry> entries_;
};

/// A value of each of `items`: a member or a function.
template <class Items, class Value>
auto each(const Items& items, const Value& value) {
  std::vector<std::decay_t<std::invoke_result_t<Value, decltype(*items.begin())>>> values;
  for (const auto& item : items) values.push_back(std::invoke(value, item));
  return values;
}

}  // namespace orbearing::described
