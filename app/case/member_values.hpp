// Members of a structure with their values, as a case writes them: the opposite of described_case.hpp.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <any>
#include <array>
#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/case/machine_fields.hpp"

namespace orbearing::app {

/// Numbers, switches, choices and texts, one by one or in lists.
template <class T>
inline constexpr bool is_written =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>;
template <class T>
inline constexpr bool is_written<std::optional<T>> = is_written<T>;
template <class T>
inline constexpr bool is_written<std::vector<T>> = is_written<T>;
template <class T, std::size_t n>
inline constexpr bool is_written<std::array<T, n>> = is_written<T>;

/// Values as a case writes them, in SI; empty: absent. Reading the text gives the same bits.
class ValueText {
 public:
  explicit ValueText(std::string_view unit) : unit_(unit.empty() ? "" : " " + std::string(unit)) {}

  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return fmt::format("{}{}", value, unit_); }
  std::string operator()(const std::string& value) const { return value; }
  template <std::integral Count>
  std::string operator()(Count value) const {
    return fmt::format("{}", value);
  }
  template <class Choice>
  requires std::is_enum_v<Choice> std::string operator()(Choice value) const {
    return std::string(described::text_of(value));
  }
  template <class Value>
  std::string operator()(const std::optional<Value>& value) const {
    return value ? (*this)(*value) : "";
  }
  template <class Value>
  std::string operator()(const std::vector<Value>& values) const {
    return values.empty() ? "" : list_of(values);
  }
  template <class Value, std::size_t n>
  std::string operator()(const std::array<Value, n>& values) const {
    return list_of(values);
  }

 private:
  template <class Values>
  std::string list_of(const Values& values) const {
    std::vector<std::string> texts;
    for (const auto& value : values) texts.push_back((*this)(value));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }

  std::string unit_;
};

/// One member, for comparison with that of another structure.
struct MemberValue {
  std::string text;      // empty: absent, or no single input states the member
  std::any whole{};      // of those that no single input states
  bool settable = true;  // else it follows from other inputs
  bool (*same)(const std::any&, const std::any&) = nullptr;

  bool operator==(const MemberValue& other) const {
    return text == other.text && same == other.same && (same == nullptr || same(whole, other.whole));
  }
};

/// A visitor of the rows of a machine: values by path, and by the number of the members of that path before
/// it, since structures may share a row.
class MemberValues {
 public:
  using Place = std::pair<std::string, int>;

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if constexpr (is_written<Member>)
      put(facts.path, {.text = ValueText(facts.details.dimension.si)(member)});
    else if constexpr (is_list_of_parts<Member>)
      put(facts.path, {.text = rows_text(member)});
    else
      put(facts.path, {.text = "", .whole = member, .settable = false, .same = are_same<Member>});
  }

  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    put(facts.path, {.text = std::visit([](const auto& one) { return std::string(one.name); }, member)});
    choose_by_inputs(self, member);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    std::visit([&](auto& chosen) { describe(self, chosen); }, member);
  }

  // Members that follow from others, as far as they have rows.
  template <class Member>
  void apart(Member& member) {
    const bool before = std::exchange(follows_, true);
    if constexpr (requires { describe(*this, member); })
      describe(*this, member);
    else if constexpr (std::is_arithmetic_v<Member>)
      put("", {.text = ValueText({})(member)});
    follows_ = before;
  }

  std::map<Place, MemberValue> values{};

 private:
  template <class Member>
  static bool are_same(const std::any& one, const std::any& other) {
    return std::any_cast<const Member&>(one) == std::any_cast<const Member&>(other);
  }

  /// The texts of one row after another.
  struct Cells {
    std::vector<std::string> texts{};
    void operator()(double& member, const described::Facts& facts) {
      texts.push_back(ValueText(facts.details.dimension.si)(member));
    }
  };
  template <class Part>
  static std::string rows_text(std::vector<Part>& parts) {
    std::vector<std::string> rows;
    for (Part& part : parts) {
      Cells cells;
      describe(cells, part);
      rows.push_back(fmt::format("[{}]", fmt::join(cells.texts, ", ")));
    }
    return rows.empty() ? "" : fmt::format("[{}]", fmt::join(rows, ", "));
  }

  void put(const std::string& path, MemberValue value) {
    value.settable = value.settable && !follows_;
    int number = 0;
    while (values.contains({path, number})) ++number;
    values.emplace(Place{path, number}, std::move(value));
  }

  bool follows_ = false;
};

/// Values of all members of a structure that have rows.
template <class Struct>
std::map<MemberValues::Place, MemberValue> member_values(const Struct& of) {
  Struct copy = of;  // visitors may change members, and this one does not
  MemberValues visit;
  describe(visit, copy);
  return std::move(visit.values);
}

}  // namespace orbearing::app
