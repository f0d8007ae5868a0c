// Steps that commands share before and after their computation: reading the case and writing the result.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/commands/common_options.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

/// The case that the caller gives, or the file with its settings. Throws BadInput as read_case().
ResolvedCase case_of(const StatedCase& stated);
/// The same for a command that computes one operating point: without the sweep. Throws as read_point().
ResolvedCase point_of(const StatedCase& stated);

/// A result as JSON: to the caller who takes it, else on standard output.
void print_object(const nlohmann::ordered_json& object, const Printing& print);
/// The same with the units of the numbers of `record`, which it was made of.
void print_result(nlohmann::ordered_json object, const Record& record, const Printing& print);
void print_warnings(const std::vector<std::string>& warnings);
/// Points that failed, in one line: to the caller who takes it, else on standard error.
void print_failures(const std::string& line, const Printing& print);

/// A case and the sweep that computes it, within its budget.
struct PlannedSweep {
  ResolvedCase resolved;
  SweepRequest request;
};

/// Limits of a sweep that is planned.
struct SweepLimits {
  std::string budget;  // processor time, "60 s"; empty: any
  std::string fidelity;
  int jobs = 0;
  bool quiet = false;  // without its estimated time
};

/// Plans `request_of` the case: with the windows that keep to the budget, where there is one, and with the
/// estimated time of its points, which is printed on standard error where it is long. Throws BadInput for a
/// budget that is too small for any windows.
PlannedSweep plan_sweep(const ResolvedCase& resolved, const SweepLimits& limits,
                        const std::function<SweepRequest(const ResolvedCase&)>& request_of);

/// Gives a sweep its folder, threads and reports, and rows to the caller who takes points.
void put_execution(const ResultPlace& place, int jobs, const Printing& print, SweepRequest& request);

/// Object that --json prints for a sweep or for one of its points, finished or not. `form` receives the
/// record of its columns.
nlohmann::ordered_json sweep_object(const ResolvedCase& resolved, const SweepOutcome& outcome, Record& form);

/// Findings of a command before its sweep.
struct FindingsBeforeSweep {
  const Record* record = nullptr;
  std::vector<std::string> warnings{};
};

/// Prints what a finished sweep found, behind what was found before: JSON, or the table and the peak; points
/// that failed are reported in any case. Returns the exit code.
int present_sweep(const ResolvedCase& resolved, const SweepOutcome& outcome, const Printing& print,
                  const FindingsBeforeSweep& before = {});

}  // namespace orbearing::app
