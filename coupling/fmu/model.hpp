// Which participant is behind the C interface, and all that is known of it before it runs: its variables,
// from which value references, both model descriptions and all access follow. Knows neither FMI nor files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/setup_numbers.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/driven_gears.hpp"

namespace orbearing::fmu {

/// All that is known of a model before it runs.
struct ModelFacts {
  std::string model;    // "bearing" or "gearset"
  std::string meaning;  // one sentence
  ShownFields shown;
  std::vector<system::Input> inputs;
  std::vector<system::Output> outputs;
};

NumberTable numbers_of(const system::DrivenBearingSetup& setup);
NumberTable numbers_of(const system::DrivenGearsSetup& setup);

/// Throws std::invalid_argument where `numbers` are those of no model.
ModelFacts facts_of(const NumberTable& numbers);

enum class Role { time, parameter, constant, input, output };

struct Variable {
  std::uint32_t reference = 0;  // position in the table
  Role role = Role::time;
  std::size_t index = 0;  // position among those of its role in the facts
  std::string name;
  std::string unit;
  std::string meaning;
  double start = 0.0;  // [unit]  not of outputs and time

  /// Constants are whole numbers; all other variables are real.
  bool whole() const { return role == Role::constant; }
};

/// Time, parameters, constants, inputs, outputs.
std::vector<Variable> variables_of(const ModelFacts& facts);

/// Reference of the first variable of `role`; those of one role follow each other.
std::uint32_t first_reference(const std::vector<Variable>& variables, Role role);

/// The model as one word, "{8-4-4-4-12}" in hexadecimal digits: a hash of variables, numbers and version.
std::string token_of(const NumberTable& numbers);

/// The version of Orbearing, of which the library is part.
const char* program_version();

/// With values of the parameters in the order of the facts. Throws std::invalid_argument where they make no
/// sense.
std::unique_ptr<system::Participant> make_participant(const NumberTable& numbers,
                                                      const std::vector<double>& parameters);

}  // namespace orbearing::fmu
