// Checks, results and analyses of machines whose cases are types, by their rows in machine_rows.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/analysis_result.hpp"
#include "app/case/machine_rows.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// A row of MachineAnalyses as values.
struct MachineAnalysis {
  Model model;
  std::string_view command;
  use::Analysis used;
  std::string other_fidelity;
  ResultNames names;
  double scatter;
  AnalysisResult (*compute)(const ResolvedCase&, const Wanted&);
};
const std::vector<MachineAnalysis>& machine_analyses();
/// That of a command; null where the model has none, or is no machine's.
const MachineAnalysis* machine_analysis(Model model, std::string_view command);

/// What of a machine is missing or does not fit together.
void check_machine(CheckedCase& in);

/// What follows from its inputs.
std::vector<Derived> machine_quantities(const ResolvedCase& in);

}  // namespace orbearing::app
