// modelDescription.xml of both versions of FMI, from the table of variables.
#pragma once

#include <string>

#include "coupling/fmu/number_table.hpp"

namespace orbearing::fmu {

/// Version of the interface that an FMU is for.
enum class Interface { fmi2, fmi3 };

/// Options of a model description besides the variables.
struct DescriptionOptions {
  Interface interface = Interface::fmi2;
  std::string name;    // of the model, any text
  double stop = 1e-3;  // [s]  of the default experiment
  double step = 1e-5;  // [s]  of the default experiment
};

/// Name of library and model inside an FMU: a C identifier.
std::string model_identifier(const NumberTable& numbers);

std::string model_description(const NumberTable& numbers, const DescriptionOptions& options);

}  // namespace orbearing::fmu
