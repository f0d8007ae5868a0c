// Rows beside the structures of parameters (mechanics/described.hpp) as rows of the table of fields.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cassert>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/case/field.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::app {

/// The row's facts but for what follows from the member: kind, choices and default.
Field field_of(const described::Facts& facts);

/// An initial value [SI] as it would be written in a case: "0.2 um", "2e-7 mm", or "1.0" without a unit.
std::string default_text(double value, const described::Details& details);

/// A visitor of rows: adds the fields of case files among them to a table. Initial values are the defaults.
/// Structures may share a row, which is added once; they then share its default.
class DescribedFields {
 public:
  explicit DescribedFields(std::vector<Field>& fields) : fields_(fields) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (facts.details.models == no_model || std::is_same_v<Member, bearing::profile::Profile>) return;
    Field field = field_of(facts);
    set_kind(field, member, facts.details);
    if (facts.details.reason.empty()) field.default_text.clear();
    add(std::move(field));
  }

  /// Kind, choices and default of the field of a member.
  static void set_kind(Field& field, bool value, const described::Details&) {
    field.kind = Kind::flag;
    field.default_text = value ? "true" : "false";
  }
  template <std::integral Count>
  static void set_kind(Field& field, Count value, const described::Details&) {
    field.kind = Kind::integer;
    field.default_text = fmt::format("{}", value);
  }
  static void set_kind(Field& field, double value, const described::Details& details) {
    field.kind = field.dimension.name.empty() ? Kind::number : Kind::quantity;
    field.default_text = default_text(value, details);
  }
  template <class Value>
  static void set_kind(Field& field, const std::optional<Value>& value, const described::Details& details) {
    set_kind(field, value.value_or(Value{}), details);
  }
  static void set_kind(Field& field, const std::vector<double>&, const described::Details&) {
    field.kind = Kind::list;
    field.element = field.dimension.name.empty() ? Kind::number : Kind::quantity;
  }
  template <class Number, std::size_t n>
  static void set_kind(Field& field, const std::array<Number, n>& values, const described::Details&) {
    field.kind = Kind::list;
    field.element = std::is_integral_v<Number> ? Kind::integer : Kind::number;
    field.default_text = fmt::format("[{}]", fmt::join(values, ", "));
  }
  template <class Number, std::size_t n>
  static void set_kind(Field& field, const std::vector<std::array<Number, n>>& values,
                       const described::Details& details) {
    set_kind(field, values.front(), details);
    field.group = n;
  }
  template <class Choice>
  requires std::is_enum_v<Choice>
  static void set_kind(Field& field, Choice value, const described::Details&) {
    field.kind = Kind::choice;
    for (const auto& name : names_of(value)) {
      field.choices.emplace_back(name.text);
      if (name.value == value) field.default_text = name.text;
    }
  }
  // Members of types that no case states.
  template <class Other>
  requires(!std::is_arithmetic_v<Other> &&
           !std::is_enum_v<Other>) static void set_kind(Field&, const Other&, const described::Details&) {
    assert(false);
  }

 private:
  // Throws std::logic_error where the table has the path with another default.
  void add(Field field);

  std::vector<Field>& fields_;
};

/// Adds the fields of a structure whose members hold the defaults.
template <class Struct>
void add_described(std::vector<Field>& fields, Struct parameters) {
  DescribedFields visit(fields);
  describe(visit, parameters);
}

}  // namespace orbearing::app
