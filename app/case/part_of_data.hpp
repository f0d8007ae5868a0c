// Parts of a case that is being read, of which values may be missing: by the rows beside the members.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "app/case/case_shape.hpp"
#include "app/case/field.hpp"
#include "app/case/resolved_case.hpp"
#include "mechanics/described.hpp"

namespace orbearing::app {

/// The value at a path in the set of that prefix; values that all sets share are at the top. Null: none.
inline const StoredValue* value_in_set(const CaseData& data, const std::string& prefix,
                                       const std::string& path) {
  if (!prefix.empty())
    if (const auto found = data.values.find(prefix + path); found != data.values.end()) return &found->second;
  const auto found = data.values.find(path);
  return found == data.values.end() ? nullptr : &found->second;
}

template <class T>
inline constexpr bool is_optional_choice = false;
template <class Choice>
inline constexpr bool is_optional_choice<std::optional<Choice>> = std::is_enum_v<Choice>;

/// The members of `Selection::Part` that `Selection::inputs` describes: found once, since parts are read for
/// each point of a sweep.
template <class Selection>
class PartOfData {
 public:
  using Part = typename Selection::Part;

  static Part read(const CaseData& data, const std::string& prefix) {
    static const std::vector<Row> rows = found_rows();
    Part part{};
    for (const Row& row : rows)
      if (const StoredValue* stored = value_in_set(data, prefix, row.path))
        row.put(stored->value, reinterpret_cast<std::byte*>(&part) + row.offset);
    return part;
  }

 private:
  struct Row {
    std::string path;
    std::ptrdiff_t offset;  // of the member in the part
    void (*put)(const FieldValue&, std::byte*);
  };

  template <class Member>
  static void put(const FieldValue& value, std::byte* at) {
    Member& member = *reinterpret_cast<Member*>(at);
    if constexpr (std::is_enum_v<Member>)
      member = value_named<Member>(value.given).value_or(member);
    else if constexpr (std::is_arithmetic_v<Member>)
      member = static_cast<Member>(value.number);
    else if constexpr (std::is_same_v<Member, std::optional<double>>)
      member = value.number;
    else if constexpr (is_optional_choice<Member>)
      member = value_named<typename Member::value_type>(value.given);
    else if constexpr (std::is_same_v<Member, std::vector<double>>)
      member = value.list;
  }

  struct Finder {
    const std::byte* begin;
    std::vector<Row>& rows;

    template <class Member>
    void operator()(Member& member, const described::Facts& facts) {
      rows.push_back({facts.path, reinterpret_cast<const std::byte*>(&member) - begin, put<Member>});
    }
  };

  static std::vector<Row> found_rows() {
    std::vector<Row> rows;
    Part part{};
    Finder visit{reinterpret_cast<const std::byte*>(&part), rows};
    Selection::inputs(visit, part);
    return rows;
  }
};

}  // namespace orbearing::app
