#include "coupling/fmu/variable_table.hpp"

namespace orbearing::fmu {

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

}  // namespace orbearing::fmu
