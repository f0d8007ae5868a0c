// Rows beside the structures of a machine (mechanics/described.hpp) as fields of cases; fields of one
// alternative among several are marked so.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/case/described_fields.hpp"
#include "app/case/field.hpp"
#include "app/case/machine_rows.hpp"

namespace orbearing::app {

/// Calls `call` with a value of each alternative, and its number.
template <class Variant, class Call, std::size_t... I>
void each_alternative(const Call& call, std::index_sequence<I...>) {
  (call(std::variant_alternative_t<I, Variant>{}, I), ...);
}
template <class Variant, class Call>
void each_alternative(const Call& call) {
  each_alternative<Variant>(call, std::make_index_sequence<std::variant_size_v<Variant>>{});
}

/// A list of structures that have rows: one column for each.
template <class T>
inline constexpr bool is_list_of_parts = false;
template <class Part>
inline constexpr bool is_list_of_parts<std::vector<Part>> = requires(Part part, int visitor) {
  describe(visitor, part);
};

template <class T>
inline constexpr std::size_t stated_count = 0;
template <class Number, std::size_t n>
inline constexpr std::size_t stated_count<std::array<Number, n>> = n;

/// A visitor of the rows of one structure as columns of a list of rows.
class ColumnsOfRows {
 public:
  void operator()(double&, const described::Facts& facts) {
    std::string name = facts.path;
    std::ranges::replace(name, '_', ' ');
    columns.push_back({name, facts.details.dimension, facts.details.range});
  }
  std::vector<ListColumn> columns{};
};

/// A visitor of the rows of a machine: its fields, which nothing uses yet.
class MachineFields {
 public:
  explicit MachineFields(Model model) : model_(model) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (!facts.internal) add_field(member, facts);
  }

  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    Field& field = add(facts);
    field.kind = Kind::choice;
    each_alternative<Variant>([&](const auto& one, std::size_t number) {
      field.choices.emplace_back(one.name);
      if (number == member.index()) field.default_text = one.name;
    });
    describe_each<Variant>(self, facts.path, [](const auto& one) { return std::string(one.name); });
  }

  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant&) {
    describe_each<Variant>(self, "one of " + std::to_string(++choices_by_inputs_),
                           [](const auto&) { return std::string(); });
  }

  std::vector<Field> fields{};

 private:
  template <class Member>
  void add_field(Member& member, const described::Facts& facts) {
    Field& field = add(facts);
    if constexpr (is_list_of_parts<Member>) {
      field.kind = field.element = Kind::list;
      ColumnsOfRows visit;
      typename Member::value_type part{};
      describe(visit, part);
      field.columns = std::move(visit.columns);
    } else {
      DescribedFields::set_kind(field, member, facts.details);
    }
    field.count = stated_count<Member>;
    if (facts.details.reason.empty()) field.default_text.clear();
    const bool required = app::is_required<Member>(facts.details);
    (alternatives_.empty() ? field.required_by : unused_) = required ? unsigned{model_} : 0u;
    field.required_if_chosen = required && !alternatives_.empty();
  }

  Field& add(const described::Facts& facts) {
    const described::Details& details = facts.details;
    fields.push_back({.path = facts.path,
                      .meaning = facts.meaning,
                      .use = Use({}, {}),
                      .models = unsigned{model_},
                      .dimension = details.dimension,
                      .range = details.range,
                      .default_reason = std::string(details.reason),
                      .numerical = details.numerical,
                      .alternatives = alternatives_});
    if (!details.where.path.empty()) fields.back().under(condition_of(details.where));
    return fields.back();
  }

  template <class Variant, class Self, class Name>
  void describe_each(Self& self, const std::string& by, const Name& name_of) {
    each_alternative<Variant>([&](auto one, std::size_t number) {
      alternatives_.push_back({by, name_of(one), number});
      describe(self, one);
      alternatives_.pop_back();
    });
  }

  Model model_;
  std::vector<Field::Alternative> alternatives_;
  int choices_by_inputs_ = 0;
  unsigned unused_ = 0;
};

/// One row of a structure as a field of other models.
template <class Struct>
Field field_of_row(std::string_view path, unsigned models, const Use& use) {
  MachineFields visit(no_model);
  Struct structure{};
  describe(visit, structure);
  Field field = *std::ranges::find(visit.fields, path, &Field::path);
  field.models = models;
  field.use = use;
  return field;
}

/// A visitor that collects the paths of a structure, those of all alternatives.
class PathsOfInputs {
 public:
  template <class Member>
  void operator()(Member&, const described::Facts& facts) {
    paths.push_back(facts.path);
  }
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    paths.push_back(facts.path);
    choose_by_inputs(self, member);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant&) {
    each_alternative<Variant>([&](auto one, std::size_t) { describe(self, one); });
  }
  std::vector<std::string> paths{};
};

template <class Inputs>
std::vector<std::string> paths_of() {
  PathsOfInputs visit;
  Inputs inputs{};
  describe(visit, inputs);
  return std::move(visit.paths);
}

/// Conditions of one use of an input, which must all hold.
struct ConditionalUse {
  std::vector<Condition> conditions;
  bool not_modelled = false;  // where they do not
  bool beside_row = false;    // as well as the use under the condition of its row
};

/// Conditional uses of the member at that path by the analysis of that number, from the type that it takes
/// (machine_conditions.cpp). None: it is always used.
std::vector<ConditionalUse> conditional_uses(std::string_view path, std::size_t analysis);

/// Fields of the machine of that model, with their uses; empty where its cases are no type.
const std::vector<Field>& fields_of_machine(Model model);

/// Adds the fields of all machines. A field that another model has as well is the same field, with the uses
/// of the machine beside its own. Throws std::logic_error where two rows of one path differ.
void add_machine_fields(std::vector<Field>& fields);

}  // namespace orbearing::app
