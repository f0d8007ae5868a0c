#include "app/case/machine_fields.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

namespace orbearing::app {

namespace {

std::map<Model, std::vector<Field>> fields_by_model() {
  std::map<Model, std::vector<Field>> all;
  Machines::each([&]<class Row>(Row, std::size_t) {
    MachineFields visit(Row::model);
    typename Row::Type machine{};
    describe(visit, machine);
    all[Row::model] = std::move(visit.fields);
  });
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    const std::vector<std::string> taken =
        paths_of<typename InputsOf<std::decay_t<decltype(Row::analyse)>>::Type>();
    for (Field& field : all.at(Row::model))
      if (std::ranges::find(taken, field.path) != taken.end())
        field.use.by |= use_of_machine_analysis(number);
  });
  return all;
}

const std::map<Model, std::vector<Field>>& all_machine_fields() {
  static const std::map<Model, std::vector<Field>> all = fields_by_model();
  return all;
}

void merge(const Field& of_machine, Field& field) {
  if (field.default_text != of_machine.default_text)
    throw std::logic_error(fmt::format("'{}' has two defaults: '{}' and '{}'", field.path, field.default_text,
                                       of_machine.default_text));
  field.models |= of_machine.models;
  field.required_by |= of_machine.required_by;
  field.use.by |= of_machine.use.by;
  field.use.not_modelled_by &= ~of_machine.use.by;
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
