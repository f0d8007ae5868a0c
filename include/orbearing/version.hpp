#pragma once

#include <string>

namespace orbearing {

/// Version of the library: "0.9.0".
std::string version();

/// Which the compiler was allowed to use: results are equal to the last bit within one only.
std::string instruction_set();

}  // namespace orbearing
