#include "coupling/fmu/import/description.hpp"

#include <pugixml.hpp>

#include "coupling/fmu/import/errors.hpp"

namespace orbearing::fmu {
namespace {

std::string required(const pugi::xml_node& node, const char* attribute) {
  const std::string text = node.attribute(attribute).value();
  if (text.empty()) {
    throw ForeignFmuError(std::string("modelDescription.xml: element ") + node.name() +
                          " has no attribute '" + attribute + "', which is required");
  }
  return text;
}

int version_of(const pugi::xml_node& root) {
  const std::string text = required(root, "fmiVersion");
  if (text.rfind("2.0", 0) == 0) return 2;
  if (text.rfind("3.", 0) == 0) return 3;
  throw ForeignFmuError("is of FMI version " + text + "; required is 2.0 or 3.0");
}

ForeignUnit unit_of(const pugi::xml_node& base) {
  constexpr std::array<const char*, 8> names = {"kg", "m", "s", "A", "K", "mol", "cd", "rad"};
  ForeignUnit unit;
  for (std::size_t i = 0; i < names.size(); ++i) unit.exponents[i] = base.attribute(names[i]).as_int(0);
  unit.factor = base.attribute("factor").as_double(1.0);
  unit.offset = base.attribute("offset").as_double(0.0);
  return unit;
}

void read_units(const pugi::xml_node& root, ForeignDescription& description) {
  for (const pugi::xml_node& node : root.child("UnitDefinitions").children("Unit")) {
    const pugi::xml_node base = node.child("BaseUnit");
    if (base) description.units[node.attribute("name").value()] = unit_of(base);
  }
}

// Units of declared types, by the type's name.
std::map<std::string, std::string> type_units(const pugi::xml_node& root) {
  std::map<std::string, std::string> units;
  for (const pugi::xml_node& node : root.child("TypeDefinitions").children()) {
    const pugi::xml_node carrier = node.child("Real") ? node.child("Real") : node;  // 2.0, 3.0
    units[node.attribute("name").value()] = carrier.attribute("unit").value();
  }
  return units;
}

// `node` names the variable; `typed` is the element whose name is the type: a child in 2.0, the same in 3.0.
ForeignVariableInfo variable_of(const pugi::xml_node& node, const pugi::xml_node& typed,
                                const std::map<std::string, std::string>& units) {
  ForeignVariableInfo variable;
  variable.name = required(node, "name");
  variable.reference = node.attribute("valueReference").as_uint(0);
  required(node, "valueReference");
  variable.type = typed.name();
  variable.causality = node.attribute("causality").as_string("local");
  variable.unit = typed.attribute("unit").value();
  variable.array = static_cast<bool>(typed.child("Dimension"));
  const auto declared = units.find(typed.attribute("declaredType").value());
  if (variable.unit.empty() && declared != units.end()) variable.unit = declared->second;
  return variable;
}

void read_variables(const pugi::xml_node& root, ForeignDescription& description) {
  const auto units = type_units(root);
  for (const pugi::xml_node& node : root.child("ModelVariables").children()) {
    if (node.type() != pugi::node_element) continue;
    pugi::xml_node typed = node;
    if (description.version == 2) {
      for (const char* type : {"Real", "Integer", "Boolean", "String", "Enumeration"}) {
        if (node.child(type)) typed = node.child(type);
      }
    }
    description.variables.push_back(variable_of(node, typed, units));
  }
}

void read_abilities(const pugi::xml_node& node, ForeignDescription& description) {
  const bool second = description.version == 2;
  const auto able = [&node](const char* name) { return node.attribute(name).as_bool(false); };
  description.identifier = required(node, "modelIdentifier");
  description.keeps_state = able(second ? "canGetAndSetFMUstate" : "canGetAndSetFMUState");
  description.serialises_state = able(second ? "canSerializeFMUstate" : "canSerializeFMUState");
  description.interpolates_inputs = second && able("canInterpolateInputs");
  description.variable_step = able("canHandleVariableCommunicationStepSize");
  description.fixed_step = node.attribute("fixedInternalStepSize").as_double(0.0);
  if (description.identifier.find('/') != std::string::npos) {
    throw ForeignFmuError("modelDescription.xml: modelIdentifier '" + description.identifier +
                          "' is not a name of the language C, which is required");
  }
}

}  // namespace

const ForeignVariableInfo* ForeignDescription::find(const std::string& name) const {
  for (const ForeignVariableInfo& variable : variables) {
    if (variable.name == name) return &variable;
  }
  return nullptr;
}

ForeignDescription read_description(const std::filesystem::path& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_file(file.c_str());
  if (!parsed) {
    throw ForeignFmuError(std::string("modelDescription.xml cannot be read: ") + parsed.description());
  }
  const pugi::xml_node root = document.child("fmiModelDescription");
  if (!root) throw ForeignFmuError("modelDescription.xml has no element fmiModelDescription");
  const pugi::xml_node node = root.child("CoSimulation");
  ForeignDescription description;
  description.version = version_of(root);
  if (!node) throw ForeignFmuError("is not for co-simulation (no element CoSimulation), which is required");
  description.model_name = root.attribute("modelName").value();
  description.token = required(root, description.version == 2 ? "guid" : "instantiationToken");
  read_abilities(node, description);
  read_units(root, description);
  read_variables(root, description);
  return description;
}

}  // namespace orbearing::fmu
