// Checks, results and analyses of machines whose cases are types, by their rows in machine_rows.hpp.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "app/case/analysis_result.hpp"
#include "app/case/machine_rows.hpp"
#include "app/case/resolved_case.hpp"
#include "app/errors.hpp"
#include "mechanics/no_result.hpp"

namespace orbearing::app {

/// A row of MachineAnalyses as values.
struct MachineAnalysis {
  Model model;
  std::string_view command;
  AnalysisId used;
  bool in_time = false;
  std::string other_fidelity;
  ResultNames names;
  double scatter;
  ProgressLine progress{};  // null: it is done at once
  AnalysisResult (*compute)(const ResolvedCase&, const AnalysisOptions&);
  double (*simulated)(const ResolvedCase&);  // [s]  time of the motion; null: none
};
const std::vector<MachineAnalysis>& machine_analyses();
/// Analysis of a command; null where the model has none, or is not a machine.
const MachineAnalysis* machine_analysis(Model model, std::string_view command);

/// Result of `compute`. Throws ComputationFailed with the name of the case where the library finds none.
template <class Compute>
auto result_for(const ResolvedCase& in, const Compute& compute) {
  try {
    return compute();
  } catch (const mechanics::NoResult& failure) {
    throw ComputationFailed(in.text("name") + ": " + failure.what());
  }
}

/// Throws BadInput where the case has no input of those that this analysis of the machine alone requires.
template <class Row>
void require_inputs(const ResolvedCase& in) {
  std::vector<std::string> missing = InputsOfRow<Row>::required();
  std::erase_if(missing, [&](const std::string& path) { return in.has(path); });
  if (!missing.empty())
    throw BadInput(fmt::format(
        "--fidelity: found dynamic for a case without {}; required: all of them, since {}, or no --fidelity",
        fmt::join(missing, ", "), Row::required_since));
}

/// Whether the case has no value that it requires: that is reported, and no more is said of it.
bool is_missing(const ResolvedCase& in, const std::string& path);

/// Mistakes in the inputs of a machine: missing values, or values that do not fit together.
void check_machine(CheckedCase& in);

/// The numbers of a record as derived quantities, whose paths begin with `prefix`.
std::vector<Derived> derived_rows(const described::Record& record, const std::string& prefix = "");
/// Quantities derived from the inputs of a machine, and warnings of them.
struct MachineQuantities {
  std::vector<Derived> rows{};
  std::vector<std::string> warnings{};
};
MachineQuantities machine_quantities(const ResolvedCase& in);

}  // namespace orbearing::app
