// An oil by its grade and temperature, instead of the single properties that follow from it.
#pragma once

#include <string>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

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

/// If `lubricant.grade` or lubricant.viscosity_40 is given, the properties of such an oil replace stated
/// ones, which then have no effect.
void fill_from_grade(CaseData& data, Model model);

/// The input that the case states for the one at `path`: its viscosity at 40 degC for a grade.
std::string stated_path(const ResolvedCase& resolved, const std::string& path);

/// Mistakes in the grade and the viscosities of an oil.
void check_grade(CheckedCase& resolved);

}  // namespace orbearing::app
