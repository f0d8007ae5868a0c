// From a resolved case of the model planetary-drivetrain to the drivetrain that it states.
#pragma once

#include <string>

#include "app/case/machine_of.hpp"
#include "app/case/resolved_case.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"

namespace orbearing::app {

/// All sets of a case, with what joins and drives them; read once for each case. Of a case by
/// ResolvedCase::of_set() that set alone.
const analysis::StatedDrivetrain& stated_drivetrain(const ResolvedCase& resolved,
                                                    Missing missing = Missing::refused);
const analysis::StatedDrivetrain& stated_drivetrain(const ResolvedCase&& resolved,
                                                    Missing missing = Missing::refused) = delete;

/// The input by which the planets of a single set carry unequal loads (analysis::unequal_loads_by); empty for
/// other cases.
std::string unequal_loads_by(const ResolvedCase& resolved);

/// The shaft of that name, and its words that mean nothing.
struct ReadShaft {
  gearset::Shaft shaft;
  std::vector<std::size_t> unknown;  // among its words
};
ReadShaft shaft_of(const ResolvedCase& resolved, const std::string& name);

}  // namespace orbearing::app
