#include "app/case/machine_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace orbearing::app {

namespace {

void add_use(Use& use, use::Analysis used, std::vector<Condition> conditions) {
  if (conditions.empty())
    use.by |= used;
  else
    use.ways.push_back({used, std::move(conditions)});
}

bool have_one_text(const std::vector<Condition>& some, const std::vector<Condition>& others) {
  return std::ranges::equal(some, others, {}, &Condition::text, &Condition::text);
}

// Conditions that all analyses have are those of the field; others hold beside those of the field.
void join_ways(Use& use) {
  if (use.ways.empty()) return;
  const std::vector<Condition> first = use.ways.front().conditions;
  const bool shared = use.by == 0 && std::ranges::all_of(use.ways, [&](const Way& way) {
                        return have_one_text(way.conditions, first);
                      });
  if (shared) {
    for (const Way& way : use.ways) use.by |= way.by;
    use.ways.clear();
    use.conditions.insert(use.conditions.end(), first.begin(), first.end());
  }
  for (Way& way : use.ways)
    way.conditions.insert(way.conditions.end(), use.conditions.begin(), use.conditions.end());
}

std::map<Model, std::vector<Field>> fields_by_model() {
  std::map<Model, std::vector<Field>> all;
  Machines::each([&]<class Row>(Row, std::size_t) {
    MachineFields visit(Row::model);
    typename Row::Type machine{};
    describe(visit, machine);
    all[Row::model] = std::move(visit.fields);
  });
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    const std::vector<std::string> taken = paths_of<InputsOfRow<Row>>();
    for (Field& field : all.at(Row::model))
      if (std::ranges::find(taken, field.path) == taken.end())
        field.use.not_modelled_by |= use_of_machine_analysis(number);
      else
        add_use(field.use, use_of_machine_analysis(number), conditions_on(field.path, number));
  });
  for (auto& [model, fields] : all)
    for (Field& field : fields) join_ways(field.use);
  return all;
}

const std::map<Model, std::vector<Field>>& all_machine_fields() {
  static const std::map<Model, std::vector<Field>> all = fields_by_model();
  return all;
}

// Uses under a condition of the machine are ways of the field, whose own conditions are those of others.
void merge(const Use& of_machine, Use& use) {
  unsigned taken = of_machine.by;
  if (of_machine.conditions.empty())
    use.by |= of_machine.by;
  else
    use.ways.push_back({of_machine.by, of_machine.conditions});
  for (const Way& way : of_machine.ways) {
    use.ways.push_back(way);
    taken |= way.by;
  }
  use.not_modelled_by = (use.not_modelled_by & ~taken) | of_machine.not_modelled_by;
}

void merge(const Field& of_machine, Field& field) {
  if (field.default_text != of_machine.default_text)
    throw std::logic_error(fmt::format("'{}' has two defaults: '{}' and '{}'", field.path, field.default_text,
                                       of_machine.default_text));
  field.models |= of_machine.models;
  field.required_by |= of_machine.required_by;
  merge(of_machine.use, field.use);
}

}  // namespace

const std::vector<Field>& fields_of_machine(Model model) {
  static const std::vector<Field> none;
  const auto found = all_machine_fields().find(model);
  return found == all_machine_fields().end() ? none : found->second;
}

void add_machine_fields(std::vector<Field>& fields) {
  Machines::each([&]<class Row>(Row, std::size_t) {
    for (const Field& field : fields_of_machine(Row::model)) {
      const auto same = std::ranges::find(fields, field.path, &Field::path);
      if (same == fields.end())
        fields.push_back(field);
      else
        merge(field, *same);
    }
  });
}

}  // namespace orbearing::app
