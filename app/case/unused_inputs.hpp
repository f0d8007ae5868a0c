// Inputs that a case states and an analysis does not use: nothing is ignored in silence.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Use of a value of a case by an analysis.
enum class UseStatus {
  used,
  neutral,       // the default, or zero where there is none: nothing is lost
  not_modelled,  // at this fidelity: see Use
  idle,          // one of its conditions does not hold
  unused,        // warned of
  refused
};

/// By the row of the field, whatever its value: used, not modelled, refused or unused.
UseStatus use_status_in_row(const ResolvedCase& resolved, const Input& input, AnalysisId analysis);

/// Whether the analysis uses the value in the present case: by its row, and by all conditions on other
/// inputs.
bool is_used(const ResolvedCase& resolved, const Input& input, AnalysisId analysis);

/// Use of the value at `path`, which the case has.
UseStatus use_status_of(const ResolvedCase& resolved, const Input& input, AnalysisId analysis);

/// Throws BadInput with all inputs that `analysis` should use and cannot; else warnings of all inputs that it
/// does not use: values without effect, and inputs that it does not model where an option of this command
/// gives them. Checks the axes of the sweep that `sweeps` names: a sweep over an unused input is refused.
enum class Axes { none, speed, all };
std::vector<std::string> require_used(const ResolvedCase& resolved, AnalysisId analysis,
                                      Axes sweeps = Axes::none);

/// Inputs of a study without effect on the analysis of this case, with a message each. An input has an effect
/// where one of its conditions can be met by another of `varied`; "path[i]" is an element of a list.
std::map<std::string, std::string> varied_without_effect(const ResolvedCase& resolved, AnalysisId analysis,
                                                         const std::vector<std::string>& varied);

/// Throws BadInput with inputs that have no effect at any of the points: a study over them is a mistake.
void require_effect(const std::vector<ResolvedCase>& points, AnalysisId analysis,
                    const std::vector<std::string>& varied);

/// Inputs of `paths`, just set, that another input replaces, each as a message.
std::vector<std::string> replaced_inputs(const ResolvedCase& resolved, const std::vector<std::string>& paths);

/// The rung of a drivetrain's run or sweep: "dynamic" is another one for several sets.
AnalysisId rung_of(const ResolvedCase& resolved, const std::string& fidelity);

/// Keys that the case gives by former names, with the present ones. In those of require_used(), too.
std::vector<std::string> former_key_warnings(const ResolvedCase& resolved);

/// Values of the case whose conditions do not hold, for `check`.
std::vector<std::string> idle_inputs(const ResolvedCase& resolved);

/// Analyses that the case's model and shape allow.
std::vector<AnalysisId> analyses_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
