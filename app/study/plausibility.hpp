// Whether numbers of a result are those of real machines.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_row.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/plausible_values.hpp"

namespace orbearing::app {

using analysis::judge;
using analysis::Judgement;
using analysis::kThinnestRim;
using analysis::Observation;

/// The values in a result as --json prints it, at any level.
std::vector<Observation> observations(const nlohmann::ordered_json& object);

/// Pressure, lives, film and their ratios at a point.
std::vector<Observation> observations(const analysis::PointNumbers& point);

/// Values from speeds and loads of the case before any bearing is solved: n_dm, pitch_line_speed_m_s,
/// unit_load_MPa, thinnest_rim. Empty for models without them.
std::vector<Observation> observations(const ResolvedCase& at_point);

/// Warning of a planet's rim that is thin for its module, before any bearing is solved; empty where none is.
std::vector<std::string> rim_warnings(const ResolvedCase& at_point);

/// The point with the status that its values deserve.
analysis::PointResult judged(analysis::PointResult result, const std::vector<analysis::NamedSet>& sets);

/// Warnings of rare values in the rows of a sweep, each once, with how many points have them.
std::vector<std::string> rare_values(const std::vector<const SweepRow*>& rows);

}  // namespace orbearing::app
