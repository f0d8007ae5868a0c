#include "coupling/fmu/export/description.hpp"

#include <array>
#include <charconv>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "coupling/fmu/model.hpp"

namespace orbearing::fmu {

namespace {

using Node = pugi::xml_node;

// Exponents of a coherent unit.
struct BaseUnit {
  int kg = 0;
  int m = 0;
  int s = 0;
  int rad = 0;
};

// Throws std::logic_error for a unit that is not in the table: an error of the program.
BaseUnit base_unit(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, BaseUnit>, 18> table{{
      {"1", {}},
      {"s", {.s = 1}},
      {"m", {.m = 1}},
      {"m/s", {.m = 1, .s = -1}},
      {"s/m", {.m = -1, .s = 1}},
      {"rad", {.rad = 1}},
      {"rad/s", {.s = -1, .rad = 1}},
      {"rad/s2", {.s = -2, .rad = 1}},
      {"kg", {.kg = 1}},
      {"kg/m3", {.kg = 1, .m = -3}},
      {"N", {.kg = 1, .m = 1, .s = -2}},
      {"N.m", {.kg = 1, .m = 2, .s = -2}},
      {"N/m", {.kg = 1, .s = -2}},
      {"N.s/m", {.kg = 1, .s = -1}},
      {"W", {.kg = 1, .m = 2, .s = -3}},
      {"Pa", {.kg = 1, .m = -1, .s = -2}},
      {"Pa.s", {.kg = 1, .m = -1, .s = -1}},
      {"1/Pa", {.kg = -1, .m = 1, .s = 2}},
  }};
  for (const auto& [name, exponents] : table)
    if (name == unit) return exponents;
  throw std::logic_error("unit " + std::string(unit) + " has no base units");
}

struct Model {
  ModelFacts facts;
  std::vector<Variable> variables;
  bool fmi3 = false;

  // FMI 2.0 counts variables from 1 where FMI 3.0 has value references.
  std::uint32_t position(std::uint32_t reference) const { return fmi3 ? reference : reference + 1; }
};

void put(Node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

// Shortest digits that give the same number again.
std::string digits(double value) {
  std::array<char, 40> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

const char* yes() {
  return "true";
}

void add_root(Node root, const Model& model, const NumberTable& numbers, const DescriptionOptions& options) {
  put(root, "fmiVersion", model.fmi3 ? "3.0" : "2.0");
  put(root, "modelName", options.name);
  put(root, model.fmi3 ? "instantiationToken" : "guid", token_of(numbers));
  put(root, "description", model.facts.meaning);
  put(root, "version", program_version());
  put(root, "generationTool", std::string("Orbearing ") + program_version());
  put(root, "variableNamingConvention", "structured");
  if (!model.fmi3) put(root, "numberOfEventIndicators", "0");
}

void add_abilities(Node root, const Model& model, const std::string& identifier) {
  Node node = root.append_child("CoSimulation");
  put(node, "modelIdentifier", identifier);
  put(node, "canBeInstantiatedOnlyOncePerProcess", "false");
  put(node, "canHandleVariableCommunicationStepSize", yes());
  put(node, "maxOutputDerivativeOrder", "0");
  if (model.fmi3) {
    for (const char* ability :
         {"canGetAndSetFMUState", "canSerializeFMUState", "providesDirectionalDerivatives",
          "providesAdjointDerivatives", "providesPerElementDependencies"})
      put(node, ability, yes());
    return;
  }
  for (const char* ability :
       {"canInterpolateInputs", "canNotUseMemoryManagementFunctions", "canGetAndSetFMUstate",
        "canSerializeFMUstate", "providesDirectionalDerivative"})
    put(node, ability, yes());
}

void add_units(Node root, const Model& model) {
  Node node = root.append_child("UnitDefinitions");
  std::set<std::string> names;
  for (const Variable& variable : model.variables)
    if (!variable.whole()) names.insert(variable.unit);
  for (const std::string& name : names) {
    Node unit = node.append_child("Unit");
    put(unit, "name", name);
    Node base = unit.append_child("BaseUnit");
    const BaseUnit exponents = base_unit(name);
    for (const auto& [key, exponent] : {std::pair{"kg", exponents.kg}, std::pair{"m", exponents.m},
                                        std::pair{"s", exponents.s}, std::pair{"rad", exponents.rad}})
      if (exponent != 0) put(base, key, std::to_string(exponent));
  }
}

void add_log_categories(Node root) {
  Node node = root.append_child("LogCategories");
  const auto add = [&](const char* name, const char* meaning) {
    Node category = node.append_child("Category");
    put(category, "name", name);
    put(category, "description", meaning);
  };
  add("logEvents", "Beginning and end of the phases of an instance");
  add("logStatusWarning", "Reasons of the status warning");
  add("logStatusDiscard", "Why a step or a value could not be computed");
  add("logStatusError", "Why a call was refused");
  add("logStatusFatal", "Why an instance cannot be used any more");
}

void add_experiment(Node root, const DescriptionOptions& options) {
  Node node = root.append_child("DefaultExperiment");
  put(node, "startTime", "0");
  put(node, "stopTime", digits(options.stop));
  put(node, "stepSize", digits(options.step));
}

struct Kind {
  const char* causality;
  const char* variability;
  const char* initial;  // null: may not be given
};

Kind kind_of(Role role) {
  switch (role) {
    case Role::time:
      return {"independent", "continuous", nullptr};
    case Role::parameter:
      return {"parameter", "fixed", "exact"};
    case Role::constant:
      return {"local", "constant", "exact"};
    case Role::input:
      return {"input", "continuous", nullptr};
    case Role::output:
      break;
  }
  return {"output", "continuous", "calculated"};
}

void add_variable(Node list, const Variable& variable, bool fmi3) {
  const char* type = fmi3 ? (variable.whole() ? "Int32" : "Float64") : "ScalarVariable";
  Node node = list.append_child(type);
  put(node, "name", variable.name);
  put(node, "valueReference", std::to_string(variable.reference));
  put(node, "description", variable.meaning);
  const Kind kind = kind_of(variable.role);
  put(node, "causality", kind.causality);
  put(node, "variability", kind.variability);
  if (kind.initial != nullptr) put(node, "initial", kind.initial);
  Node typed = fmi3 ? node : node.append_child(variable.whole() ? "Integer" : "Real");
  if (!variable.whole()) put(typed, "unit", variable.unit);
  if (variable.role != Role::output && variable.role != Role::time)
    put(typed, "start", digits(variable.start));
}

void add_variables(Node root, const Model& model) {
  Node node = root.append_child("ModelVariables");
  for (const Variable& variable : model.variables) add_variable(node, variable, model.fmi3);
}

void add_unknown(Node parent, const char* name, const Model& model, const Variable& output,
                 const std::vector<std::uint32_t>& references) {
  Node node = parent.append_child(name);
  put(node, model.fmi3 ? "valueReference" : "index", std::to_string(model.position(output.reference)));
  std::string positions, kinds;
  for (const std::uint32_t reference : references) {
    positions += (positions.empty() ? "" : " ") + std::to_string(model.position(reference));
    kinds += kinds.empty() ? "dependent" : " dependent";
  }
  put(node, "dependencies", positions);
  put(node, "dependenciesKind", kinds);
}

std::vector<std::uint32_t> references_of(const Model& model, const std::vector<std::size_t>& inputs) {
  std::vector<std::uint32_t> references;
  for (const std::size_t input : inputs)
    references.push_back(first_reference(model.variables, Role::input) + static_cast<std::uint32_t>(input));
  return references;
}

std::vector<std::uint32_t> start_references(const Model& model, const system::Output& output) {
  std::vector<std::uint32_t> references;
  if (output.start_parameters)
    for (const Variable& variable : model.variables)
      if (variable.role == Role::parameter) references.push_back(variable.reference);
  for (const std::uint32_t reference : references_of(model, output.start_inputs))
    references.push_back(reference);
  return references;
}

void add_structure(Node root, const Model& model) {
  Node structure = root.append_child("ModelStructure");
  Node outputs = model.fmi3 ? structure : structure.append_child("Outputs");
  for (const Variable& variable : model.variables)
    if (variable.role == Role::output)
      add_unknown(outputs, model.fmi3 ? "Output" : "Unknown", model, variable,
                  references_of(model, model.facts.outputs[variable.index].inputs));
  Node initial = model.fmi3 ? structure : structure.append_child("InitialUnknowns");
  for (const Variable& variable : model.variables)
    if (variable.role == Role::output)
      add_unknown(initial, model.fmi3 ? "InitialUnknown" : "Unknown", model, variable,
                  start_references(model, model.facts.outputs[variable.index]));
}

}  // namespace

std::string model_identifier(const NumberTable& numbers) {
  return "orbearing_" + numbers.model;
}

std::string model_description(const NumberTable& numbers, const DescriptionOptions& options) {
  const ModelFacts facts = facts_of(numbers);
  const Model model{facts, variables_of(facts), options.interface == Interface::fmi3};
  pugi::xml_document document;
  Node declaration = document.append_child(pugi::node_declaration);
  put(declaration, "version", "1.0");
  put(declaration, "encoding", "UTF-8");
  Node root = document.append_child("fmiModelDescription");
  add_root(root, model, numbers, options);
  add_abilities(root, model, model_identifier(numbers));
  add_units(root, model);
  add_log_categories(root);
  add_experiment(root, options);
  add_variables(root, model);
  add_structure(root, model);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace orbearing::fmu
