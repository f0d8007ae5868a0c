// What in a case makes the planets of a set carry unlike loads.
#pragma once

#include <string>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// The path of the value by which planets carry unlike loads: pins off their places, or places at unequal
/// steps; empty: none does. Of the one set of a case, or of one of several by ResolvedCase::of_set().
std::string uneven_planets_by(const ResolvedCase& resolved);

}  // namespace orbearing::app
