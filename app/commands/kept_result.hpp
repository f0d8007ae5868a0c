// Common output of analyses that give one result and no sweep.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/commands/common_options.hpp"
#include "app/results/manifest.hpp"
#include "app/study/analysis.hpp"

namespace orbearing::app {

/// Opens the folder, computes, keeps what is not kept yet and prints. Returns the exit code.
int compute_and_keep(const ResolvedCase& resolved, const ResultPlace& place, const Printing& print,
                     const ResultNames& names, const std::function<AnalysisResult()>& compute);

/// The same of a row of the table of analyses, with its progress; refuses and warns of inputs that it does
/// not use.
int run_analysis(const ResolvedCase& resolved, const ResultPlace& place, const Printing& print,
                 const Analysis& analysis);
/// JSON of the analysis as `run --json` prints it.
nlohmann::ordered_json printed_json(const ResolvedCase& resolved, const Analysis& analysis);

/// Bytes of the netCDF file of a result called `what`.
std::string result_file(const ManifestHeader& header, const char* what, const Record& record,
                        const std::string& status = "ok");

/// Prints a result as JSON, or its text and its warnings.
void present_result(const nlohmann::ordered_json& object, const std::string& text, const Printing& print);

/// Prints a record as JSON with the case's name, warnings and units, or as text followed by `more`.
void present_record(const ResolvedCase& resolved, const Record& record,
                    const std::vector<std::string>& warnings, const Printing& print,
                    const std::string& more = "");

}  // namespace orbearing::app
