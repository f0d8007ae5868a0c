// What in a case makes the planets of a set carry unlike loads.
#pragma once

#include <string>
#include <string_view>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether the case has a list at `path` with a value that is not zero.
bool is_anywhere_nonzero(const ResolvedCase& resolved, std::string_view path);

/// The path of the value by which planets carry unlike loads: pins off their places, or places at unequal
/// steps; empty: none does. Of the one set of a case, or of one of several by ResolvedCase::of_set().
std::string uneven_planets_by(const ResolvedCase& resolved);

}  // namespace orbearing::app
