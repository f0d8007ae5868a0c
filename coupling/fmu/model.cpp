#include "coupling/fmu/model.hpp"

#include <algorithm>
#include <stdexcept>

namespace orbearing::fmu {

namespace {

using system::DrivenBearing;
using system::DrivenBearingSetup;
using system::DrivenGears;
using system::DrivenGearsSetup;

// The result of `call` for the setup in `numbers` and the type of its model.
template <class Call>
auto of_model(const NumberTable& numbers, const Call& call) {
  if (numbers.model == "bearing")
    return call.template operator()<DrivenBearing>(setup_from<DrivenBearingSetup>(numbers));
  if (numbers.model == "gearset")
    return call.template operator()<DrivenGears>(setup_from<DrivenGearsSetup>(numbers));
  throw std::invalid_argument("model: found '" + numbers.model + "'; required: bearing or gearset");
}

// Beginnings of the names of what changes nothing in this model: no parameter of its FMU.
std::vector<std::string_view> without_effect(const DrivenBearingSetup& setup) {
  const bearing::motion::DynamicsParameters& given = setup.dynamics;
  const bearing::motion::RaceContactParameters& race = given.race;
  const bool mixed = race.lubrication == bearing::motion::Lubrication::mixed;
  std::vector<std::string_view> names;
  const auto none_if = [&](bool idle, std::initializer_list<std::string_view> some) {
    if (idle) names.insert(names.end(), some);
  };
  none_if(given.bore_mass > 0.0, {"bearing.outside_diameter"});  // the mass of the bore is stated
  none_if(setup.bearing.has_cage(), {"bearing.neighbour_friction"});
  none_if(!setup.bearing.has_cage(), {"bearing.cage."});
  none_if(given.cage.guide_diameter <= 0.0,
          {"bearing.cage.largest_eccentricity", "bearing.cage.touch_down_stiffness"});
  const bool shears_oil = nature_of(race.traction).shears_oil;
  none_if(shears_oil, {"traction.friction"});
  none_if(!shears_oil, {"traction.limiting_friction"});
  none_if(!mixed, {"contact.boundary_friction"});
  none_if(!mixed && !race.squeeze, {"contact.roughness"});
  none_if(!given.drag.on, {"lubricant.density", "lubricant.share"});
  none_if(setup.bearing.rollers().laminae == 0, {"bearing.misalignment."});
  return names;
}

// A member that is held has no motion for its mass, springs and dampers.
std::vector<std::string> without_effect(const DrivenGearsSetup& setup) {
  std::vector<std::string> names;
  const auto add = [&](const char* body, std::initializer_list<const char*> some) {
    for (const char* one : some) names.push_back(std::string("gearset.dynamics.") + body + one);
  };
  const auto add_held = [&](const char* body, const gearset::dynamics::CentralMember& member) {
    if (member.support.held) add(body, {".mass", ".support_stiffness", ".support_damping"});
    if (member.support.held_in_rotation)
      add(body, {".equivalent_mass", ".torsional_stiffness", ".torsional_damping"});
  };
  add_held("sun", setup.set.sun);
  add_held("ring", setup.set.ring);
  add_held("carrier", setup.set.carrier);
  return names;
}

template <class Setup>
ShownFields fields_of(const Setup& setup) {
  ShownFields fields = shown_fields(setup);
  const auto names = without_effect(setup);
  for (std::vector<ShownField>* list : {&fields.parameters, &fields.constants})
    std::erase_if(*list, [&](const ShownField& field) {
      return std::any_of(names.begin(), names.end(),
                         [&](const auto& name) { return field.facts.name.starts_with(name); });
    });
  return fields;
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

namespace {

void add(std::vector<Variable>& table, Role role, std::size_t index, const std::string& name,
         const std::string& unit, const std::string& meaning, double start) {
  table.push_back({static_cast<std::uint32_t>(table.size()), role, index, name, unit, meaning, start});
}

void add_fields(std::vector<Variable>& table, Role role, const std::vector<ShownField>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    add(table, role, i, fields[i].facts.name, fields[i].facts.unit, fields[i].facts.meaning, fields[i].start);
}

std::string hexadecimal(std::uint64_t number) {
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; number >>= 4) text[i] = "0123456789abcdef"[number & 15u];
  return text;
}

}  // namespace

std::vector<Variable> variables_of(const ModelFacts& facts) {
  std::vector<Variable> table;
  add(table, Role::time, 0, "time", "s", "simulation time", 0.0);
  add_fields(table, Role::parameter, facts.shown.parameters);
  add_fields(table, Role::constant, facts.shown.constants);
  for (std::size_t i = 0; i < facts.inputs.size(); ++i) {
    const system::Input& input = facts.inputs[i];
    add(table, Role::input, i, input.name, input.unit, input.meaning, input.start);
  }
  for (std::size_t i = 0; i < facts.outputs.size(); ++i) {
    const system::Output& output = facts.outputs[i];
    add(table, Role::output, i, output.name, output.unit, output.meaning, 0.0);
  }
  return table;
}

std::uint32_t first_reference(const std::vector<Variable>& variables, Role role) {
  for (const Variable& variable : variables)
    if (variable.role == role) return variable.reference;
  return static_cast<std::uint32_t>(variables.size());
}

std::string token_of(const NumberTable& numbers) {
  std::string names;
  for (const Variable& variable : variables_of(facts_of(numbers)))
    names += variable.name + '\n' + variable.unit + '\n';
  const std::string all = text_of(numbers) + names + program_version();
  const std::string high = hexadecimal(hash_of(all)), low = hexadecimal(hash_of(all, hash_of(names)));
  return '{' + high.substr(0, 8) + '-' + high.substr(8, 4) + '-' + high.substr(12) + '-' + low.substr(0, 4) +
         '-' + low.substr(4) + '}';
}

const char* program_version() {
  return ORBEARING_VERSION;
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
