// `orbearing run` of whatever gives one result and no point of a sweep; `orbearing modes` of a duplex pair.
//
// Each runs, writes the folder, prints, and returns the exit code. Each throws BadInput and
// ComputationFailed.
#pragma once

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/manifest.hpp"
#include "app/study/defect_study.hpp"

namespace orbearing::app {

/// Names of the files of a result folder that hold what `run --json` prints: of a ball bearing in time, of a
/// bearing with scratches.
inline constexpr const char* ball_file_name = "ball.json";
inline constexpr const char* defect_file_name = "defect.json";

/// One bearing by itself, under a static load or, of balls, in time.
int run_static_case(const ResolvedCase& resolved, const Options& options);
int run_ball_case(const ResolvedCase& resolved, const Options& options);

/// A bearing with scratches; a gear set with a scratched planet bearing.
int run_defect_case(const ResolvedCase& resolved, const Options& options);
int run_planet_defect_case(const ResolvedCase& resolved, const Options& options);

/// The film of a contact.
int run_film_case(const ResolvedCase& resolved, const Options& options);

/// A shaft on a duplex pair; duplex_modes() writes no folder.
int run_duplex_case(const ResolvedCase& resolved, const Options& options);
int duplex_modes(const ResolvedCase& resolved, const Options& options);

/// A planetary set without the dynamics of its bearings, and whether a case has no other run.
int run_gear_case(const ResolvedCase& resolved, const Options& options);
bool runs_gears_alone(const ResolvedCase& resolved);

/// Throws BadInput where all of a scratched bearing is to move and cannot.
void require_rung(const ResolvedCase& resolved, bool moving);

/// The netCDF file of a scratched bearing's signal, and its row in the table of a folder.
std::string defect_file(const ManifestHeader& header, const DefectStudy& study);
ResultRow defect_row(const TableHead& head, const DefectStudy& study);

}  // namespace orbearing::app
