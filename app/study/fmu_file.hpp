// An FMU as a file: what is packed, and where the libraries inside it come from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupling/fmu/export/description.hpp"

namespace orbearing::app {

/// The library of one platform, as it was built beside the program.
struct FmuLibrary {
  std::string platform;  // folder inside the FMU
  std::string file;      // name inside the FMU
  std::string content;
};

/// Libraries found beside the program, and what is missing.
struct FmuLibraries {
  std::vector<FmuLibrary> found;
  std::vector<std::string> missing;  // one line for each, with the remedy
};

/// Builds a library that is missing where a program build_<platform> stands beside the others, and says so on
/// standard error unless `quiet`. Throws ComputationFailed where there is none at all.
FmuLibraries fmu_libraries(const fmu::NumberTable& numbers, fmu::Interface interface, bool quiet);

/// The archive's bytes.
std::string fmu_content(const fmu::NumberTable& numbers, const fmu::DescriptionOptions& options,
                        const std::vector<FmuLibrary>& libraries);

}  // namespace orbearing::app
