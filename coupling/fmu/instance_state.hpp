// All that an instance's future depends on, and its form as bytes for another process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/system/participant.hpp"

namespace orbearing::fmu {

enum class Phase { instantiated, initializing, stepping, terminated };

struct InstanceState {
  Phase phase = Phase::instantiated;
  bool experiment_set = false;
  bool has_stop = false;
  bool computed = false;  // the participant holds a state
  double time = 0.0;      // [s]
  double stop = 0.0;      // [s]
  std::vector<double> parameters;
  std::vector<double> inputs;
  std::vector<bool> given;     // inputs that the importer set
  std::vector<double> first;   // [unit/s]    derivatives of the inputs for the next step
  std::vector<double> second;  // [unit/s^2]
  std::vector<bool> has_first;
  system::SavedState participant;
};

/// How many numbers of each kind a model has.
struct StateSizes {
  std::size_t parameters = 0;
  std::size_t inputs = 0;
};

/// Header (magic, format, length, hashes of program version and model, checksum), then all numbers.
/// @param model hash of the model and the program's version
std::string bytes_of(const InstanceState& state, std::uint64_t model);
std::size_t byte_number(const InstanceState& state);

/// Throws Refused with the reason where `bytes` are not a whole state of this model and version.
InstanceState state_from(const char* bytes, std::size_t size, std::uint64_t model, const StateSizes& sizes);

}  // namespace orbearing::fmu
