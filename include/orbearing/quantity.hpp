// Quantities as cases state them: a number with its unit.
#pragma once

#include <string>

#include "orbearing/errors.hpp"

namespace orbearing {

/// The number of a quantity such as "3 mm" in another unit of its dimension: 3000 for "um". Throws BadInput.
double in_unit(const std::string& quantity, const std::string& unit);

}  // namespace orbearing
