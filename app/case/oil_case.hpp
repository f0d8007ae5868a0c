// An oil by its grade and temperature, instead of the single properties that follow from it.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/film/oil_grade.hpp"

namespace orbearing::app {

// Values that follow from another input and replace stated ones: oil by its grade, a bearing by its
// designation.

/// Gives the input at `path` the value `text`, as it would be written in a case, with `reason` among the
/// assumptions. A stated value that differs is kept for the warning that it has no effect. Nothing happens
/// where the field does not accept the value: the case must state one.
void substitute(CaseData& data, const std::string& path, const std::string& text, const std::string& reason);

/// The same where nothing is stated; a stated value remains.
void put_where_absent(CaseData& data, const std::string& path, const std::string& text,
                      const std::string& reason);

/// The grade of an oil whose viscosities at 40 and 100 degC the case states.
inline constexpr const char* kStatedGrade = "stated";

/// Density of the oil [kg/m^3]: the stated one where it has an effect, else that of a mineral oil.
double oil_density(const ResolvedCase& resolved);

/// The oil that `lubricant.grade` names, or of which lubricant.viscosity_40 and viscosity_100 state the
/// viscosities.
bearing::OilGrade graded_oil(const ResolvedCase& resolved);
/// Whether the case states what that oil is. Else it is refused by check_grade().
bool is_known_oil(const ResolvedCase& resolved);
/// Its properties at its temperature.
bearing::Lubricant graded_lubricant(const ResolvedCase& resolved);
/// Relative decrease of its viscosity per kelvin [1/K].
double graded_viscosity_slope(const ResolvedCase& resolved);

/// If `lubricant.grade` or lubricant.viscosity_40 is given, the properties of such an oil replace stated
/// ones, which then have no effect.
void fill_from_grade(CaseData& data, Model model);

/// The input that the case states for the one at `path`: its viscosity at 40 degC for a grade.
std::string stated_path(const ResolvedCase& resolved, const std::string& path);

/// Mistakes in the grade and the viscosities of an oil.
void check_grade(CheckedCase& resolved);

}  // namespace orbearing::app
