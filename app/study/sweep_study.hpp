// The sweep of a case: its points, how each is computed, where life peaks, and its warnings.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/sensitivity.hpp"

namespace orbearing::app {

/// Throws BadInput where the case's model has no operating points, or no bearing whose life they could give.
void require_planet_bearings(const ResolvedCase& resolved);

/// The grid of the sweep of `resolved`, or its one operating point where the case has no sweep; folder, jobs
/// and the like, and whether the peak is refined, are left to the caller. Throws as
/// require_planet_bearings().
SweepRequest sweep_request(const ResolvedCase& resolved, const std::string& fidelity);

/// Its point at another speed [rpm] on the line of speeds of the point that `settings` make.
SweepPoint point_at_rpm(const ResolvedCase& resolved, std::vector<Setting> settings, double rpm);

/// Computes the operating point that `settings` make of the case.
analysis::PointResult compute_point(const ResolvedCase& resolved, const std::vector<Setting>& settings,
                                    analysis::Fidelity fidelity);

/// Header of the manifest of `resolved`, for `points` points computed as `fidelity` names.
ManifestHeader manifest_header(const ResolvedCase& resolved, const std::string& fidelity,
                               std::size_t points = 1);

/// Column of a swept field other than input.speed in the table: in its customary unit, or as a plain number;
/// and its value in the case.
SweptAxis axis_column(const std::string& path);
double axis_value(const ResolvedCase& resolved, const std::string& path);

/// Makes `request` follow its branch: each point from the final state of its neighbour in speed. Throws
/// BadInput, with every mistake, where the points have no motion (fidelity) or no neighbour (axes).
void continue_from_neighbours(const ResolvedCase& resolved, Direction direction, SweepRequest& request);

/// `assumptions` and `versions` as results carry them, and what the case states as it is written.
nlohmann::ordered_json assumptions_json(const ResolvedCase& resolved);
/// The same, with `effect` on the lives where there is one.
nlohmann::ordered_json assumptions_json(const ResolvedCase& resolved,
                                        const std::vector<AssumedEffect>& effects);
nlohmann::ordered_json given_json(const ResolvedCase& resolved);
nlohmann::ordered_json versions_json();

}  // namespace orbearing::app
