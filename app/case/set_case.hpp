// From a resolved case of the model planetary-drivetrain to the parameters of its set with teeth.
#pragma once

#include "app/case/resolved_case.hpp"
#include "gearset/parameters.hpp"

namespace orbearing::app {

/// The set with the bore that its bearings fill; where it has none, with the bore that the case states as a
/// share of the root diameter of standard teeth.
gearset::PlanetarySet set_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
