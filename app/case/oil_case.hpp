// An oil by its grade and temperature, in place of the single properties that follow from it.
#pragma once

#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Density of the oil [kg/m^3]: the stated one where it counts, that of a mineral oil where it does not.
double oil_density(const ResolvedCase& resolved);

/// Where `lubricant.grade` is given, the properties of such an oil stand in place of what is stated, which
/// then has no effect.
void fill_from_grade(CaseData& data, Model model);

/// Whether anything is known of such an oil.
void check_grade(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
