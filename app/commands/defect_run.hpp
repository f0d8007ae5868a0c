// The analysis of a bearing with scratches: `orbearing run` of the model raceway-defect.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/manifest.hpp"
#include "app/study/defect_study.hpp"

namespace orbearing::app {

/// Name of the file of a result folder that holds what `run --json` prints.
inline constexpr const char* defect_file_name = "defect.json";

/// The netCDF file of a signal.
std::string defect_file(const ManifestHeader& header, const DefectStudy& study);

/// Its row in the table of a folder, whose columns are of lives: all but the largest load stay empty.
ResultRow defect_row(const TableHead& head, const DefectStudy& study);

/// Throws BadInput where all of the bearing is to move and cannot.
void require_rung(const ResolvedCase& resolved, bool moving);

/// Runs, writes the folder, prints. Returns the exit code. Throws BadInput and ComputationFailed.
int run_defect_case(const ResolvedCase& resolved, const Options& options);

}  // namespace orbearing::app
