// The file with a model's numbers among the resources of an unpacked FMU.
#pragma once

#include <string>

namespace orbearing::fmu {

inline constexpr const char* kModelFile = "model.txt";

/// Folder of a resource location as FMI 2.0 gives it, a URI with the scheme file (%xx decoded), or as FMI 3.0
/// does, a path. Throws Refused for NULL, other schemes, other hosts and broken %xx.
std::string resource_folder(const char* location);

/// Throws Refused where the file cannot be read.
std::string read_model(const std::string& folder);

}  // namespace orbearing::fmu
