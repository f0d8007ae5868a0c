// SI units of the variables as products of base units.
#pragma once

#include <string_view>

namespace orbearing::fmu {

/// Exponents of a coherent unit.
struct BaseUnit {
  int kg = 0;
  int m = 0;
  int s = 0;
  int rad = 0;
};

/// Throws std::logic_error for a unit that is not in the table: an error of the program.
BaseUnit base_unit(std::string_view unit);

}  // namespace orbearing::fmu
