// report.json: data of the page of a sweep besides the points themselves. The page requests separately what
// only figures use: fine curves, loads by position, single effects (python/orbearing/report_data.py).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/manifest.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/validation_table.hpp"

namespace orbearing::app {

// Comparison of a report with published numbers: the case as published, at speeds that were computed.

/// The one line of speeds of a sweep with several axes that plots over speed show.
struct SpeedSlice {
  ResolvedCase at;                    // the case with the other axes at that point
  std::vector<std::string> settings;  // which puts it there, as with --set
  nlohmann::ordered_json columns;  // column of the table -> value, one for each other axis; null without any
};

/// The line nearest to the case's own values; the case itself where speed is not swept or nothing else is.
SpeedSlice speed_slice(const ResolvedCase& resolved);

/// Published numbers of the shipped case of the same name. They belong to it: of a case whose inputs differ
/// there is nothing to compare, and `changed` names what differs, "input.power: 75 kW (published: 150 kW)".
struct PublishedComparison {
  std::vector<std::string> changed;
  ValidationTable table;  // rows alone, of the shipped case on the speeds of its own sweep
};
PublishedComparison published_comparison(const ResolvedCase& resolved);

/// Inputs of one case that differ from another's, in the order in which they are written; not those that
/// choose operating points: speed, sweep, load spectrum.
std::vector<std::string> changed_inputs(const ResolvedCase& resolved, const ResolvedCase& shipped);

/// Data of a sweep whose rows are in `manifest`. Its member `shown` has the bearing and the speeds of the
/// figures, as bearing_points() takes them.
nlohmann::ordered_json report_data(const ResolvedCase& resolved, const Manifest& manifest);

/// Operating points of one bearing under changes of the case, on the gears as the case states them: a change
/// is made in the bearing alone. `wanted` holds `settings` of the case, `set` (empty: the only one),
/// `changes`, each a list of settings, `speeds` [rad/s], `fidelity` and `loads` (whether by place). A list of
/// points for each change; null for one that does not fit the case.
nlohmann::ordered_json bearing_points(const ResolvedCase& resolved, const nlohmann::ordered_json& wanted,
                                      bool progress);

/// Whether a case is one of a planetary set whose gears have teeth.
bool has_gear_report(const ResolvedCase& resolved);

/// Teeth, meshes, modes and motion of the gears over the speeds of a sweep [rpm], of which the page makes its
/// figures (python/orbearing/gear_data.py). The gears alone run in time at these and at speeds between; a run
/// that fails has the reason in its `status`.
nlohmann::ordered_json gear_report(const ResolvedCase& resolved, std::vector<double> speeds_rpm);

/// Missing points of a sweep in a folder of results: points that a shard leaves to others or that were not
/// computed yet.
struct MissingPoints {
  std::size_t of = 0;               // points of grid and spectrum of the whole sweep
  std::vector<std::string> labels;  // "input.speed = 6000 rpm", of each that is missing
  bool peak_unfinished = false;     // the grid is whole, and points that refine its peak are missing

  bool none() const { return labels.empty() && !peak_unfinished; }
};

/// Missing points of a sweep or of one point. Reads only `manifest`, and computes nothing.
MissingPoints missing_points(const ResolvedCase& resolved, const Manifest& manifest);

/// In a sentence with what to do; empty where nothing is missing.
std::string missing_text(const MissingPoints& missing, const Manifest& manifest);

/// {of, found, shard, points, peak_unfinished, text}; null where nothing is missing.
nlohmann::ordered_json missing_json(const MissingPoints& missing, const Manifest& manifest);

/// A dynamic sweep and its folder: a branch of steady states over speed.
struct Branch {
  std::filesystem::path folder;
  Manifest manifest;
};

/// Throws BadInput, with every reason, unless both are dynamic sweeps of one case that differ in the
/// direction of --continue and in nothing else.
void require_two_branches(const Branch& one, const Branch& other);

/// `load_drift` (rms loads that differ by less are one state) and `runs`: `name` ("up", "down" or "own
/// start") and `points`, the rows of the sweep. Null where no sweep of `branches` is continued.
nlohmann::ordered_json branches_json(const ResolvedCase& resolved, const std::vector<Branch>& branches);

}  // namespace orbearing::app
