// Steps that commands share before and after their computation: reading the case and writing the result.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

/// The case of `options`: that of the caller, or the file with its settings. Throws BadInput as read_case().
ResolvedCase case_of(const Options& options);
/// The same for a command that computes one operating point: without the sweep. Throws as read_point().
ResolvedCase point_of(const Options& options);

/// A result as JSON: to the caller who takes it, else on standard output.
void print_object(const nlohmann::ordered_json& object, const Options& options);
/// The same with the units of the numbers of `record`, which it was made of.
void print_result(nlohmann::ordered_json object, const Record& record, const Options& options);
void print_warnings(const std::vector<std::string>& warnings);
/// Points that failed, in one line: to the caller who takes it, else on standard error.
void print_failures(const std::string& line, const Options& options);

/// A case and the sweep that computes it, within the budget of the options.
struct PlannedSweep {
  ResolvedCase resolved;
  SweepRequest request;
};

/// Plans `request_of` the case: with the windows that keep to the budget, where there is one, and with the
/// estimated time of its points, which is printed on standard error where it is long. Throws BadInput for a
/// budget that is too small for any windows.
PlannedSweep plan_sweep(const ResolvedCase& resolved, const Options& options,
                        const std::function<SweepRequest(const ResolvedCase&)>& request_of);

/// Folder, threads and reports of a sweep as the options have them, and rows to the caller who takes points.
void put_options(const Options& options, SweepRequest& request);

/// Object that --json prints for a sweep or for one of its points, finished or not. `form` receives the
/// record of its columns.
nlohmann::ordered_json sweep_object(const ResolvedCase& resolved, const SweepOutcome& outcome, Record& form);

/// Findings of a command before its sweep.
struct FoundBefore {
  const Record* record = nullptr;
  std::vector<std::string> warnings{};
};

/// Prints what a finished sweep found, behind what was found before: JSON, or the table, the chart and the
/// peak; points that failed are reported in any case. Returns the exit code.
int present_sweep(const ResolvedCase& resolved, const SweepOutcome& outcome, const Options& options,
                  const FoundBefore& before = {});

}  // namespace orbearing::app
