#include "coupling/fmu/model.hpp"

#include <stdexcept>

namespace orbearing::fmu {

namespace {

using system::DrivenBearing;
using system::DrivenBearingSetup;
using system::DrivenGears;
using system::DrivenGearsSetup;

// The result of `call` for the setup that `numbers` are of, and what stands behind it.
template <class Call>
auto of_model(const NumberTable& numbers, const Call& call) {
  if (numbers.model == "bearing")
    return call.template operator()<DrivenBearing>(setup_from<DrivenBearingSetup>(numbers));
  if (numbers.model == "gearset")
    return call.template operator()<DrivenGears>(setup_from<DrivenGearsSetup>(numbers));
  throw std::invalid_argument("model: found '" + numbers.model + "'; required: bearing or gearset");
}

// Of a bearing what it has: a cage, or neighbours that touch.
ShownFields fields_of(const DrivenBearingSetup& setup) {
  ShownFields fields = shown_fields(setup);
  const std::string_view absent = setup.bearing.has_cage() ? "bearing.neighbour_friction" : "bearing.cage.";
  for (std::vector<ShownField>* list : {&fields.parameters, &fields.constants})
    std::erase_if(*list, [&](const ShownField& field) { return field.facts.name.starts_with(absent); });
  return fields;
}
ShownFields fields_of(const DrivenGearsSetup& setup) {
  return shown_fields(setup);
}

const char* meaning_of(const std::string& model) {
  return model == "bearing"
             ? "One cylindrical roller bearing of one planet: rollers, cage if any, and pin ring in the "
               "carrier's frame"
             : "A planetary gear set whose planet bearings are computed elsewhere";
}

}  // namespace

NumberTable numbers_of(const DrivenBearingSetup& setup) {
  return numbers_of_setup("bearing", setup);
}
NumberTable numbers_of(const DrivenGearsSetup& setup) {
  return numbers_of_setup("gearset", setup);
}

ModelFacts facts_of(const NumberTable& numbers) {
  return of_model(numbers, [&]<class Driven>(const auto& setup) -> ModelFacts {
    const Driven driven(setup);
    return {numbers.model, meaning_of(numbers.model), fields_of(setup), driven.inputs(), driven.outputs()};
  });
}

std::unique_ptr<system::Participant> make_participant(const NumberTable& numbers,
                                                      const std::vector<double>& parameters) {
  NumberTable own = numbers;
  const std::vector<ShownField> fields =
      of_model(numbers, []<class>(const auto& setup) { return fields_of(setup).parameters; });
  for (std::size_t i = 0; i < fields.size(); ++i)
    for (NumberRow& row : own.rows)
      if (row.name == fields[i].facts.name) row.values = {parameters.at(i)};
  return of_model(own, []<class Driven>(const auto& setup) -> std::unique_ptr<system::Participant> {
    return std::make_unique<Driven>(setup);
  });
}

}  // namespace orbearing::fmu
