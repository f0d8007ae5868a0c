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

namespace orbearing::app {

/// Members that a case may leave out: absent ones, and lists of numbers, which are empty then.
template <class T>
inline constexpr bool may_be_left_out = described::is_optional<T> || std::is_same_v<T, std::vector<double>>;

/// Whether a case cannot do without the member. One that counts under a condition alone is not required.
template <class Member>
bool is_required(const described::Details& details) {
  return details.reason.empty() && details.where.path.empty() && !details.may_be_absent &&
         !may_be_left_out<Member>;
}

/// The row's facts but for what follows from the member: kind, choices and default.
Field field_of(const described::Facts& facts, unsigned models);

/// An initial value [SI] as it would be written in a case: "0.2 um", "2e-7 mm", or "1.0" without a unit.
std::string default_text(double value, const described::Details& details);

/// A visitor of rows: adds the fields of case files among them to a table. Initial values are the defaults.
/// Structures may share a row, which is added once; they then share its default.
class DescribedFields {
 public:
  DescribedFields(std::vector<Field>& fields, unsigned models) : fields_(fields), models_(models) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (facts.internal) return;
    Field field = field_of(facts, models_);
    if (is_required<Member>(facts.details)) field.required_by |= models_;
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
  static void set_kind(Field& field, const std::string&, const described::Details&) {
    field.kind = Kind::text;
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
  unsigned models_;
};

/// Adds the fields of a structure whose members hold the defaults, for cases of `models`; none: the machines
/// that have them add their own.
template <class Struct>
void add_described(std::vector<Field>& fields, Struct parameters, unsigned models = planetary_drivetrain) {
  DescribedFields visit(fields, models);
  describe(visit, parameters);
}

}  // namespace orbearing::app
