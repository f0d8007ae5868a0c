// What an FMU says about itself: modelDescription.xml of FMI 2.0 [FMI2] and 3.0 [FMI3], as far as a master
// of co-simulation needs it.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace orbearing::fmu {

/// value in SI units = factor x value + offset; exponents of kg, m, s, A, K, mol, cd, rad.
struct ForeignUnit {
  std::array<int, 8> exponents{};
  double factor = 1.0;
  double offset = 0.0;
};

struct ForeignVariableInfo {
  std::string name;
  unsigned reference = 0;
  std::string type;       // as the standard calls it: Real, Integer, ... in 2.0; Float64, Int32, ... in 3.0
  std::string causality;  // input, output, parameter, local, ...
  std::string unit;       // empty where none is stated
  bool array = false;

  bool is_real() const { return (type == "Real" || type == "Float64") && !array; }
};

struct ForeignDescription {
  int version = 2;  // 2 or 3
  std::string model_name;
  std::string token;       // guid in 2.0, instantiationToken in 3.0
  std::string identifier;  // name of the library, without suffix
  bool keeps_state = false;
  bool serialises_state = false;
  bool interpolates_inputs = false;  // 2.0 alone
  bool variable_step = false;        // takes communication steps of unlike lengths
  double fixed_step = 0.0;           // [s]  3.0: steps are multiples of this one; 0 where it says nothing
  std::vector<ForeignVariableInfo> variables;
  std::map<std::string, ForeignUnit> units;

  /// Null where there is none.
  const ForeignVariableInfo* find(const std::string& name) const;
};

/// Throws ForeignFmuError where the file cannot be read, is of another version or not for co-simulation.
ForeignDescription read_description(const std::filesystem::path& file);

}  // namespace orbearing::fmu
