// An oil by its grade and temperature, in place of the single properties that follow from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// A field that follows from the grade: its path, its value as it would be written in a case, and why.
struct OilProperty {
  std::string path;
  std::string text;
  std::string reason;
};

/// Density of the oil [kg/m^3]: the stated one where it counts, that of a mineral oil where it does not.
double oil_density(const ResolvedCase& resolved);

/// All of them. `number` gives the value of a field [SI]. Throws std::invalid_argument for an oil of which
/// nothing is known.
std::vector<OilProperty> properties_of_grade(const std::string& grade,
                                             const std::function<double(const char*)>& number);

/// Where `lubricant.grade` is given they stand in place of what is stated, which then has no effect.
void fill_from_grade(CaseData& data, Model model);

/// Whether anything is known of such an oil.
void check_grade(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
