// The variables of an FMU, from which value references, both model descriptions and all access follow.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/fmu/model.hpp"

namespace orbearing::fmu {

enum class Role { time, parameter, constant, input, output };

struct Variable {
  std::uint32_t reference = 0;  // place in the table
  Role role = Role::time;
  std::size_t index = 0;  // place among those of its role in the facts
  std::string name;
  std::string unit;
  std::string meaning;
  double start = 0.0;  // [unit]  not of outputs and time

  /// Constants are whole numbers; all other variables are real.
  bool whole() const { return role == Role::constant; }
};

/// Time, parameters, constants, inputs, outputs.
std::vector<Variable> variables_of(const ModelFacts& facts);

/// Of the first variable of `role`; those of one role follow each other.
std::uint32_t first_reference(const std::vector<Variable>& variables, Role role);

/// The model as one word, "{8-4-4-4-12}" in hexadecimal digits: a hash of variables, numbers and version.
std::string token_of(const NumberTable& numbers);

/// The version of Orbearing, of which the library is part.
const char* program_version();

}  // namespace orbearing::fmu
