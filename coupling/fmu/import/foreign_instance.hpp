// One running FMU of co-simulation, of either version of the standard.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "coupling/fmu/import/description.hpp"
#include "coupling/fmu/import/shared_library.hpp"

namespace orbearing::fmu {

/// Numbers for variables of type Real, Integer, Boolean (0: false), Float64, Int32 or Int64; text for String.
using StartValue = std::variant<double, std::string>;
using References = std::vector<unsigned>;

/// The calls of the standard in the order in which it wants them: set_start, enter_initialization, set,
/// exit_initialization, then for each step set, set_slopes, step, get; states at any time after that. It is
/// terminated and freed with the object.
///
/// Whatever status but OK and Warning is thrown as ForeignFmuError, with the name of the call and what the
/// FMU logged lately. After the status Fatal the FMU is not called again.
class ForeignInstance {
 public:
  virtual ~ForeignInstance() = default;

  virtual void set_start(const ForeignVariableInfo& variable, const StartValue& value) = 0;
  virtual void enter_initialization(double time) = 0;  // [s]
  virtual void exit_initialization() = 0;

  /// Values in the units of the FMU, one for each reference.
  virtual void set(const References& references, const std::vector<double>& values) = 0;
  virtual void get(const References& references, std::vector<double>& values) = 0;
  /// Derivatives of inputs by time, of `order` 1 and up, at the beginning of the next step; 2.0 alone.
  virtual void set_slopes(const References& references, int order, const std::vector<double>& values) = 0;
  virtual void step(double begin, double length) = 0;  // [s], [s]

  /// States are the FMU's own memory; whoever takes one frees it.
  virtual void* take_state() = 0;
  virtual void set_state(void* state) = 0;
  virtual void free_state(void* state) noexcept = 0;
  virtual std::vector<unsigned char> serialised(void* state) = 0;
  virtual void* deserialised(const std::vector<unsigned char>& bytes) = 0;
};

/// What an instance needs for its life; outlives it.
struct LoadedFmu {
  ForeignDescription description;
  std::filesystem::path resources;  // an absolute folder
  const SharedLibrary* library = nullptr;
};

std::unique_ptr<ForeignInstance> instantiate_fmi2(const LoadedFmu& fmu, const std::string& name);
std::unique_ptr<ForeignInstance> instantiate_fmi3(const LoadedFmu& fmu, const std::string& name);

/// A file URI [FMI2] of an absolute path, percent-encoded.
std::string file_uri(const std::filesystem::path& path);

}  // namespace orbearing::fmu
